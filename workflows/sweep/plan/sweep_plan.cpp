#include "workflows/sweep/plan/sweep_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/random/sobol.hpp>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/options/enum_names.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::sweep {
namespace {

using base::in_quotes;
using base::IniSetting;
using SweepLines = std::map<std::string, IniSetting>;

void require_at_most_max_points(double count) {
  if (count <= static_cast<double>(kMaxPoints)) return;
  throw InputError(fmt::format("a plan of {:.3g} points (at most {}: vary less, or split the plan)",
                               count, kMaxPoints));
}

void require_axis_values(const SweepAxis& axis) {
  if (!axis.values.empty()) return;
  throw InputError(fmt::format("{} has no number of points (write {}:N, or --design sobol)",
                               axis.axis_definition_text(), axis.axis_definition_text()));
}

SweepPlanPoints cartesian_product_points(const std::vector<SweepAxis>& axes) {
  double count = 1;
  for (const auto& axis : axes) {
    require_axis_values(axis);
    count *= static_cast<double>(axis.values.size());
    require_at_most_max_points(count);
  }
  SweepPlanPoints points{{}};
  for (const auto& axis : axes) {
    SweepPlanPoints longer;
    for (const auto& point : points) {
      for (const auto& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

SweepPlanPoints listed_points(const std::vector<SweepAxis>& axes) {
  for (const auto& axis : axes) {
    require_axis_values(axis);
    if (axis.values.size() == axes.front().values.size()) continue;
    throw InputError(
        fmt::format("{} has {} values and {} has {} (in a list all keys must have as many)",
                    axes.front().key, axes.front().values.size(), axis.key, axis.values.size()));
  }
  SweepPlanPoints points(axes.front().values.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const auto& axis : axes) points[k].push_back(axis.values[k]);
  }
  return points;
}

// Returns points of the Sobol sequence (Sobol 1967; direction numbers of Joe and Kuo 2008). The
// first point of the Sobol sequence, a corner of the box of parameter ranges, is omitted.
SweepPlanPoints sobol_points_in_box(const std::vector<SweepAxis>& axes, std::size_t count) {
  if (count == 0) {
    throw InputError("the design sobol has no number of points (give --points N)");
  }
  require_at_most_max_points(static_cast<double>(count));
  for (const auto& axis : axes) {
    if (axis.spacing == SweepAxisSpacing::listed) {
      throw InputError(fmt::format("{} with the design sobol (it fills ranges: give FROM:TO)",
                                   axis.axis_definition_text()));
    }
    if (!axis.values.empty()) {
      throw InputError(
          fmt::format("{} with the design sobol (--points sets the number: give FROM:TO)",
                      axis.axis_definition_text()));
    }
  }
  boost::random::sobol engine(axes.size());
  const double above = static_cast<double>(boost::random::sobol::max()) + 1;
  SweepPlanPoints points(count);
  for (auto& point : points) {
    for (const auto& axis : axes) {
      point.emplace_back(axis.value_at_fraction(static_cast<double>(engine()) / above));
    }
  }
  return points;
}

constexpr const char* kSweep = "sweep";
constexpr const char* kVary = "vary";

std::size_t parse_point_count(const IniSetting& line) {
  const auto count = base::parse_number<std::size_t>(line.text);
  if (count && *count > 0 && *count <= kMaxPoints) return *count;
  throw InputError(fmt::format("{}: points {} (must be an integer, 1 .. {})", line.where,
                               in_quotes(line.text), kMaxPoints));
}

SweepLines extract_sweep_lines(const std::vector<IniSetting>& all) {
  SweepLines lines;
  for (const auto& line : all) {
    if (line.section != kSweep) continue;
    if (!lines.emplace(line.key, line).second) {
      throw InputError(fmt::format("{}: key '{}' is given twice (keep one)", line.where,
                                   line.ini_section_and_key()));
    }
  }
  return lines;
}

}  // namespace

SweepPlanPoints make_sweep_plan_points(const std::vector<SweepAxis>& axes, SweepPlanDesign design,
                                       std::size_t sobol_points) {
  if (axes.empty()) {
    throw InputError("nothing is varied (give --vary KEY=FROM:TO:N, log:FROM:TO:N or A,B,..)");
  }
  for (const auto& axis : axes) {
    if (std::ranges::count(axes, axis.key, &SweepAxis::key) > 1) {
      throw InputError(fmt::format("{} is varied twice (keep one)", axis.key));
    }
  }
  if (design != SweepPlanDesign::sobol && sobol_points != 0) {
    throw InputError("a number of points without the design sobol (the values of the axes set it)");
  }
  switch (design) {
    case SweepPlanDesign::product:
      return cartesian_product_points(axes);
    case SweepPlanDesign::list:
      return listed_points(axes);
    case SweepPlanDesign::sobol:
      return sobol_points_in_box(axes, sobol_points);
  }
  return {};
}

void require_known_constants(const problem::Problem& base, const std::vector<SweepAxis>& axes) {
  constexpr std::string_view kParameters = "parameters.";
  for (const auto& axis : axes) {
    if (!axis.key.starts_with(kParameters)) continue;
    const std::string name = axis.key.substr(kParameters.size());
    if (!base.system.named_constants().contains(name)) {
      throw InputError(
          fmt::format("{} is varied, but [parameters] of {} has no {}; correct the name", axis.key,
                      base.name, name));
    }
  }
}

problem::Problem SweepPlan::problem_at_sweep_point(std::size_t point) const {
  auto sections = problem::case_file_sections(base);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const std::string& key = axes[a].key;
    const auto dot = key.find('.');
    auto section = std::ranges::find(sections, key.substr(0, dot), &problem::CaseFileSection::name);
    if (section == sections.end()) {
      section = sections.insert(section, {.name = key.substr(0, dot), .values = {}});
    }
    auto value =
        std::ranges::find(section->values, key.substr(dot + 1), &base::NamedParameterValue::name);
    if (value == section->values.end()) {  // the base case lacks this optional key
      value = section->values.insert(value, {.name = key.substr(dot + 1), .value = {}});
    }
    value->value = points[point][a];
  }
  return problem::problem_from_sections(base.name, sections);
}

ParsedSweepPlan read_sweep_plan(const std::string& name_or_path,
                                const std::vector<std::string>& overrides) {
  constexpr std::size_t kMaxBytes = 1 << 20;
  const bool named = problem::find_built_in_case(name_or_path) != nullptr;
  const auto text = named ? std::nullopt : base::read_input_file(name_or_path, kMaxBytes);
  if (!text) return {problem::load_case(name_or_path, overrides)};

  std::istringstream ini(*text);
  const std::string where = fmt::format("plan {}", base::to_printable_text(name_or_path));
  const auto all = base::read_ini_settings(ini, where);
  std::vector<IniSetting> of_case;
  std::ranges::copy_if(all, std::back_inserter(of_case), [](const IniSetting& line) {
    return line.section != kSweep && line.section != kVary;
  });
  if (of_case.size() == all.size()) return {problem::load_case(name_or_path, overrides)};

  const SweepLines lines = extract_sweep_lines(all);
  const auto base_case = lines.find("case");
  if (base_case != lines.end() && !of_case.empty()) {
    throw InputError(fmt::format("{}: a case beside [{}] (keep one)", base_case->second.where,
                                 of_case.front().section));
  }
  ParsedSweepPlan plan{base_case != lines.end()
                           ? problem::load_case(base_case->second.text, overrides)
                           : problem::problem_from_settings(
                                 of_case, std::filesystem::path(name_or_path).stem().string(),
                                 where, overrides, problem::CaseNamingRule::from_file,
                                 std::filesystem::path(name_or_path).parent_path())};
  for (const auto& line : all) {
    if (line.section == kVary)
      plan.axes.push_back(parse_sweep_axis(line.key, line.text, line.where));
  }
  for (const auto& [key, line] : lines) {
    if (key == "case") continue;
    if (key == "design") {
      plan.design = base::parse_enum<SweepPlanDesign>(line.where + ": design", line.text);
    } else if (key == "closure_errors") {
      plan.closure_errors =
          base::parse_enum<ClosureErrorSource>(line.where + ": closure_errors", line.text);
    } else if (key == "points") {
      plan.points = parse_point_count(line);
    } else if (key == "methods") {
      plan.methods = line.text;
    } else {
      plan.options.push_back(line);
    }
  }
  return plan;
}

}  // namespace fpkcheck::sweep
