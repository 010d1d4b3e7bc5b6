#include "methods/external/given_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "epc/density.hpp"
#include "methods/external/between_walls.hpp"
#include "methods/external/column_meaning.hpp"
#include "methods/external/form_file.hpp"
#include "methods/external/joint_table.hpp"
#include "results/joint_netcdf.hpp"
#include "results/plain_joint.hpp"

namespace fpkcheck::methods {
namespace {

GivenJoint joint_of_points(JointTable table, const std::string& path) {
  const std::size_t nv = table.v.size();
  GivenJoint joint{.path = path, .form = "joint points", .numbers = table.p.size()};
  // The density is taken as 0 beyond the table.
  constexpr double kSmall = 1e-3;
  const double peak = std::ranges::max(table.p);
  double end = 0;
  for (std::size_t k = 0; k < table.p.size(); ++k) {
    const bool last = k / nv + 1 == table.y.size() || k % nv == 0 || k % nv + 1 == nv;
    if (last) end = std::max(end, table.p[k]);
  }
  if (end > kSmall * peak) {
    joint.notes.push_back(
        fmt::format("p(y, y') is cut off at {:.2g} of its peak and taken as 0 beyond", end / peak));
  }
  joint.values = [path, table = std::make_shared<const JointTable>(std::move(table))](
                     const problem::Problem&, const DensityPoints& points) {
    require_between(points.walls(), table->y.front(), table->y.back(), path);
    return values_at(*table, points);
  };
  return joint;
}

GivenJoint joint_of_run(const GivenArgument& argument, const std::string& where,
                        const std::string& usual_case, const Registry& registry) {
  auto file = results::read_joint_netcdf(argument.file);
  std::vector<std::string> cases, solutions;
  for (const auto& [case_name, joint] : file.joints) {
    if (std::ranges::find(cases, case_name) == cases.end()) cases.push_back(case_name);
  }
  auto asked = argument.case_name;
  if (!asked && std::ranges::find(cases, usual_case) != cases.end()) asked = usual_case;
  const std::string& of_case = cases[chosen(cases, asked, "case", where)];
  std::vector<const transform::GridDensity*> densities;
  for (const auto& [case_name, joint] : file.joints) {
    if (case_name != of_case) continue;
    solutions.push_back(joint.solution);
    densities.push_back(&joint.density);
  }
  const auto place = chosen(solutions, argument.solution, "solution", where);
  const auto& cells = *densities[place];
  GivenJoint joint{.path = where, .form = "joint cells", .numbers = cells.averages.size()};
  const auto finite = [](double p) { return std::isfinite(p); };
  if (!std::ranges::all_of(cells.averages, finite)) {
    throw InputError(fmt::format("{}: {} has values that are not finite", where,
                                 base::in_quotes(solutions[place])));
  }
  if (const auto method = registry.by_id(solutions[place])) {
    joint.equation = method->identity.equation;
    joint.impact = method->identity.impact;
    joint.order = method->identity.order;
  }
  joint.values = [where, own = std::make_shared<const transform::GridDensity>(cells)](
                     const problem::Problem&, const DensityPoints& points) {
    require_between(points.walls(), own->y_edges.front(), own->y_edges.back(), where);
    return values_at(*own, points);
  };
  return joint;
}

// The first parameter of the file's problem that differs from the run's; empty if none differs.
std::string difference(const problem::Problem& of_file, const problem::Problem& of_run) {
  const auto here = problem::sections(of_run);
  for (const auto& section : problem::sections(of_file)) {
    const auto same = std::ranges::find(here, section.name, &problem::Section::name);
    for (const auto& value : section.values) {
      if (same != here.end() && std::ranges::find(same->values, value) != same->values.end()) {
        continue;
      }
      return fmt::format("{}.{} = {}", section.name, value.name, base::text_of(value.value));
    }
  }
  return {};
}

JointTable table_of(results::PlainJoint plain, const std::string& where) {
  const std::vector<std::string> names{plain.first_name, plain.second_name, "p"};
  const auto of_v = velocity_column(names);
  if (of_v >= names.size()) {
    throw InputError(fmt::format("{}: {} has the coordinates {} and {}; name them y and v", where,
                                 base::sanitise(plain.name), base::sanitise(names[0]),
                                 base::sanitise(names[1])));
  }
  if (of_v == 1) return {std::move(plain.first), std::move(plain.second), std::move(plain.values)};
  JointTable table{std::move(plain.second), std::move(plain.first), {}};
  for (std::size_t i = 0; i < table.y.size(); ++i) {
    for (std::size_t j = 0; j < table.v.size(); ++j) {
      table.p.push_back(plain.values[j * table.y.size() + i]);
    }
  }
  return table;
}

}  // namespace

GivenJoint joint_of_table(const NumberTable& table) {
  return joint_of_points(joint_table_of(table), table.source);
}

GivenJoint joint_of_netcdf(const GivenArgument& argument, std::string bytes,
                           const std::string& usual_case, const Registry& registry) {
  const std::string where = base::sanitise(argument.file.string());
  if (results::is_joint_netcdf(bytes)) return joint_of_run(argument, where, usual_case, registry);
  if (argument.solution || argument.case_name) {
    throw InputError(fmt::format("{} contains a single density; omit the key {}", where,
                                 argument.solution ? "solution" : "case"));
  }
  auto table = table_of(results::read_plain_joint(std::move(bytes), where), where);
  require_usable(table, where);
  return joint_of_points(std::move(table), where);
}

GivenJoint joint_of_json(const GivenArgument& argument, const std::string& text,
                         const std::string& usual_case) {
  const std::string where = base::sanitise(argument.file.string());
  auto file = std::make_shared<const FormFile>(
      read_form(text, where, {argument.solution, argument.case_name, usual_case}));
  const auto& [form, problem, solution] = *file;
  GivenJoint joint{.path = where, .form = "closed form", .numbers = form.q.terms().size()};
  // A normalisation constant in an external file is checked; that of a saved run is not.
  joint.normalise = solution.has_value() || !form.frame.log_constant;
  using enum epc::Variables;
  if (form.frame.variables == plane || form.frame.variables == physical) {
    joint.order = form.q.degree();
  }
  if (solution) {
    joint.problem = problem;
    joint.equation = solution->identity.equation;
    joint.impact = solution->identity.impact;
    joint.order = solution->identity.order;
    const bool of_use = solution->is_ok() || solution->status == transform::Status::inaccurate;
    if (!of_use) {
      joint.objection =
          fmt::format("the status in the file is {}: {}", name(solution->status), solution->reason);
    }
  }
  joint.values = [file](const problem::Problem& of_run, const DensityPoints& points) {
    const auto density = epc::density(file->form, file->problem ? &*file->problem : &of_run);
    std::vector<double> values;
    values.reserve(points.y().size() * points.v().size());
    for (const double y : points.y()) {
      for (const double v : points.v()) values.push_back(density.value(y, v));
    }
    return values;
  };
  return joint;
}

Method method_of(const OwnDensity& own, const GivenJoint& joint) {
  const auto check = [own, joint](const problem::Problem& problem) {
    const DensityPoints points(compare::comparison_axes(problem), problem.system.walls());
    return require_density(own, points, joint.values(problem, points));
  };
  const auto solve = [own, joint](const problem::Problem& problem, const Setting& setting) {
    const DensityPoints points(setting.axes, problem.system.walls());
    auto values = joint.values(problem, points);
    const double mass = require_density(own, points, values);
    auto solution = solution_of(problem, setting, own,
                                {.normalise = joint.normalise, .objection = joint.objection},
                                points, std::move(values), mass);
    auto notes = joint.notes;
    constexpr double kNearOne = 0.1;
    if (joint.normalise && std::abs(mass - 1) > kNearOne && joint.form != "closed form") {
      notes.push_back(fmt::format("the density was divided by its integral, {:.4g}", mass));
    }
    const auto other = joint.problem ? difference(*joint.problem, problem) : std::string();
    if (!other.empty())
      notes.push_back(fmt::format("the density is of another problem: {}", other));
    transform::MetricBuilder builder;
    builder.text("files[0].file", joint.path)
        .text("files[0].form", joint.form)
        .work("files[0].numbers", transform::count_value(joint.numbers));
    if (notes.empty()) builder.add_empty_list("files[0].notes", transform::Kind::text);
    for (std::size_t n = 0; n < notes.size(); ++n) {
      builder.text(fmt::format("files[0].notes[{}]", n), notes[n]);
    }
    std::ranges::move(builder.take(), std::back_inserter(solution.metrics));
    return solution;
  };
  return {.identity = identity_of(own, transform::kExternalFile, "from a file"),
          .solve = solve,
          .check = [check](const problem::Problem& problem) { check(problem); }};
}

}  // namespace fpkcheck::methods
