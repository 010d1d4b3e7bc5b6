#include "workflows/sweep/plan/plan_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/files/ini_file.hpp"
#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/options/parse_enum.hpp"
#include "base/text/sanitise.hpp"
#include "problem/case_file.hpp"
#include "problem/named_cases.hpp"

namespace fpkcheck::sweep {
namespace {

using base::in_quotes;
using base::IniSetting;

constexpr const char* kSweep = "sweep";
constexpr const char* kVary = "vary";

std::size_t parse_point_count(const IniSetting& line) {
  std::size_t count = 0;
  const char *const begin = line.text.data(), *const end = begin + line.text.size();
  if (std::from_chars(begin, end, count).ptr == end && count > 0 && count <= kMaxPoints) {
    return count;
  }
  throw InputError(fmt::format("{}: points {} (must be an integer, 1 .. {})", line.where,
                               in_quotes(line.text), kMaxPoints));
}

/// The lines of the section [sweep], by key.
using SweepLines = std::map<std::string, IniSetting>;

SweepLines sweep_lines(const std::vector<IniSetting>& all) {
  SweepLines lines;
  for (const auto& line : all) {
    if (line.section != kSweep) continue;
    if (!lines.emplace(line.key, line).second) {
      throw InputError(
          fmt::format("{}: key '{}' is given twice (keep one)", line.where, line.path()));
    }
  }
  return lines;
}

}  // namespace

PlanSpecification read_plan(const std::string& name_or_path,
                            const std::vector<std::string>& overrides) {
  constexpr std::size_t kMaxBytes = 1 << 20;
  const bool named = problem::find_built_in_case(name_or_path) != nullptr;
  const auto text = named ? std::nullopt : base::read_input_file(name_or_path, kMaxBytes);
  if (!text) return {problem::load_case(name_or_path, overrides)};

  std::istringstream ini(*text);
  const std::string where = fmt::format("plan {}", base::sanitise(name_or_path));
  const auto all = base::read_ini_settings(ini, where);
  std::vector<IniSetting> of_case;
  std::ranges::copy_if(all, std::back_inserter(of_case), [](const IniSetting& line) {
    return line.section != kSweep && line.section != kVary;
  });
  if (of_case.size() == all.size()) return {problem::load_case(name_or_path, overrides)};

  const SweepLines lines = sweep_lines(all);
  const auto base_case = lines.find("case");
  if (base_case != lines.end() && !of_case.empty()) {
    throw InputError(fmt::format("{}: a case beside [{}] (keep one)", base_case->second.where,
                                 of_case.front().section));
  }
  PlanSpecification plan{base_case != lines.end()
                             ? problem::load_case(base_case->second.text, overrides)
                             : problem::case_from_settings(
                                   of_case, std::filesystem::path(name_or_path).stem().string(),
                                   where, overrides, problem::CaseNaming::from_file,
                                   std::filesystem::path(name_or_path).parent_path())};
  for (const auto& line : all) {
    if (line.section == kVary) plan.axes.push_back(parse_axis(line.key, line.text, line.where));
  }
  for (const auto& [key, line] : lines) {
    if (key == "case") continue;
    if (key == "design") {
      plan.design = base::parse_enum<PlanDesign>(line.where + ": design", line.text);
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
