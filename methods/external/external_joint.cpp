#include "methods/external/external_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "epc/closed_form_density.hpp"
#include "methods/external/density_file.hpp"
#include "methods/external/joint_table.hpp"
#include "methods/external/number_table.hpp"
#include "methods/external/range_between_walls.hpp"
#include "results/joint_netcdf.hpp"

namespace fpkcheck::methods {
namespace {

ExternalJointDensity joint_from_points(JointTable table, const std::string& path) {
  const std::size_t nv = table.v.size();
  ExternalJointDensity joint{.path = path, .form = "joint points", .numbers = table.p.size()};
  // Outside the range of the table the density is taken as 0. If a density value at an outermost
  // point of the table exceeds kSmall times the peak, a note states that the density is cut off.
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
                     const problem::Problem&, const DensityQuadratureGrid& points) {
    require_range_between_walls(points.walls(), table->y.front(), table->y.back(), path);
    return evaluate_at_quadrature_points(*table, points);
  };
  return joint;
}

ExternalJointDensity joint_from_run(const ExternalDensityArgument& argument,
                                    const std::string& where, const std::string& default_case,
                                    const SolverRegistry& registry) {
  auto file = results::read_joint_netcdf(argument.file);
  std::vector<std::string> cases, solutions;
  for (const auto& [case_name, joint] : file.joints) {
    if (std::ranges::find(cases, case_name) == cases.end()) cases.push_back(case_name);
  }
  auto requested = argument.case_name;
  if (!requested && std::ranges::find(cases, default_case) != cases.end()) requested = default_case;
  const std::string& of_case = cases[index_of_requested_name(cases, requested, "case", where)];
  std::vector<const transform::GridDensity*> densities;
  for (const auto& [case_name, joint] : file.joints) {
    if (case_name != of_case) continue;
    solutions.push_back(joint.solution);
    densities.push_back(&joint.density);
  }
  const auto place = index_of_requested_name(solutions, argument.solution, "solution", where);
  const auto& cells = *densities[place];
  ExternalJointDensity joint{
      .path = where, .form = "joint cells", .numbers = cells.averages.size()};
  const auto finite = [](double p) { return std::isfinite(p); };
  if (!std::ranges::all_of(cells.averages, finite)) {
    throw InputError(fmt::format("{}: {} has values that are not finite", where,
                                 base::in_quotes(solutions[place])));
  }
  if (const auto method = registry.find_method_by_id(solutions[place])) {
    joint.equation = method->identity.equation;
    joint.impact = method->identity.impact;
    joint.order = method->identity.order;
  }
  joint.values = [where, external = std::make_shared<const transform::GridDensity>(cells)](
                     const problem::Problem&, const DensityQuadratureGrid& points) {
    require_range_between_walls(points.walls(), external->y_edges.front(), external->y_edges.back(),
                                where);
    return evaluate_at_quadrature_points(*external, points);
  };
  return joint;
}

// Returns the first parameter that differs between the problem of a density file and the problem of
// the run; an empty text for equal problems.
std::string first_difference(const problem::Problem& of_file, const problem::Problem& of_run) {
  const auto here = problem::case_file_sections(of_run);
  for (const auto& section : problem::case_file_sections(of_file)) {
    const auto same = std::ranges::find(here, section.name, &problem::CaseFileSection::name);
    for (const auto& value : section.values) {
      if (same != here.end() && std::ranges::find(same->values, value) != same->values.end()) {
        continue;
      }
      return fmt::format("{}.{} = {}", section.name, value.name, base::value_as_text(value.value));
    }
  }
  return {};
}

JointTable to_joint_table(results::NetCdfJointDensityVariable variable, const std::string& where) {
  const std::vector<std::string> names{variable.first_name, variable.second_name, "p"};
  const auto of_v = velocity_column_index(names);
  if (of_v >= names.size()) {
    throw InputError(fmt::format("{}: {} has the coordinates {} and {}; name them y and v", where,
                                 base::to_printable_text(variable.name),
                                 base::to_printable_text(names[0]),
                                 base::to_printable_text(names[1])));
  }
  if (of_v == 1)
    return {std::move(variable.first), std::move(variable.second), std::move(variable.values)};
  JointTable table{std::move(variable.second), std::move(variable.first), {}};
  for (std::size_t i = 0; i < table.y.size(); ++i) {
    for (std::size_t j = 0; j < table.v.size(); ++j) {
      table.p.push_back(variable.values[j * table.y.size() + i]);
    }
  }
  return table;
}

}  // namespace

ExternalJointDensity joint_density_from_table(const NumberTable& table) {
  return joint_from_points(make_joint_table(table), table.source);
}

ExternalJointDensity joint_density_from_netcdf(const ExternalDensityArgument& argument,
                                               std::string bytes, const std::string& default_case,
                                               const SolverRegistry& registry) {
  const std::string where = base::to_printable_text(argument.file.string());
  if (results::is_joint_netcdf(bytes))
    return joint_from_run(argument, where, default_case, registry);
  if (argument.solution || argument.case_name) {
    throw InputError(fmt::format("{} contains a single density; omit the key {}", where,
                                 argument.solution ? "solution" : "case"));
  }
  auto table =
      to_joint_table(results::read_external_joint_density_variable(std::move(bytes), where), where);
  require_valid_joint_table(table, where);
  return joint_from_points(std::move(table), where);
}

ExternalJointDensity joint_density_from_json(const ExternalDensityArgument& argument,
                                             const std::string& text,
                                             const std::string& default_case) {
  const std::string where = base::to_printable_text(argument.file.string());
  auto file = std::make_shared<const ClosedFormDensityFile>(
      read_closed_form_file(text, where, {argument.solution, argument.case_name, default_case}));
  const auto& [form, problem, solution] = *file;
  ExternalJointDensity joint{
      .path = where, .form = "closed form", .numbers = form.q.terms().size()};
  // Only for a closed form from another program is the normalisation constant tested.
  joint.normalise = solution.has_value() || !form.frame.log_constant;
  using enum epc::ExponentCoordinates;
  if (form.frame.variables == plane || form.frame.variables == physical) {
    joint.order = form.q.degree();
  }
  if (solution) {
    joint.problem = problem;
    joint.equation = solution->identity.equation;
    joint.impact = solution->identity.impact;
    joint.order = solution->identity.order;
    const bool has_usable_density =
        solution->has_status_ok() || solution->status == transform::Status::inaccurate;
    if (!has_usable_density) {
      joint.inadmissible_reason =
          fmt::format("the status in the file is {}: {}", name(solution->status), solution->reason);
    }
  }
  joint.values = [file](const problem::Problem& of_run, const DensityQuadratureGrid& points) {
    const auto density =
        epc::density_of_closed_form(file->form, file->problem ? &*file->problem : &of_run);
    std::vector<double> values;
    values.reserve(points.y_points().size() * points.v_points().size());
    for (const double y : points.y_points()) {
      for (const double v : points.v_points()) values.push_back(density.value(y, v));
    }
    return values;
  };
  return joint;
}

Method make_method_from_joint_density(const ExternalDensity& external,
                                      const ExternalJointDensity& joint) {
  const auto check = [external, joint](const problem::Problem& problem) {
    const DensityQuadratureGrid points(compare::comparison_bins(problem), problem.system.walls());
    return validated_density_integral(external, points, joint.values(problem, points));
  };
  const auto solve = [external, joint](const problem::Problem& problem,
                                       const SolverInputContext& context) {
    const DensityQuadratureGrid points(context.axes, problem.system.walls());
    auto values = joint.values(problem, points);
    const double mass = validated_density_integral(external, points, values);
    auto solution = make_external_density_solution(
        problem, context, external,
        {.normalise = joint.normalise, .inadmissible_reason = joint.inadmissible_reason}, points,
        std::move(values), mass);
    auto notes = joint.notes;
    constexpr double kNearOne = 0.1;
    if (joint.normalise && std::abs(mass - 1) > kNearOne && joint.form != "closed form") {
      notes.push_back(fmt::format("the density was divided by its integral, {:.4g}", mass));
    }
    const auto other = joint.problem ? first_difference(*joint.problem, problem) : std::string();
    if (!other.empty())
      notes.push_back(fmt::format("the density is of another problem: {}", other));
    transform::SolverMetricsBuilder builder;
    builder.add_text_metric("files[0].file", joint.path)
        .add_text_metric("files[0].form", joint.form)
        .add_diagnostic_metric("files[0].numbers", transform::value_from_count(joint.numbers));
    if (notes.empty()) builder.add_empty_list("files[0].notes", transform::SolverMetricKind::text);
    for (std::size_t n = 0; n < notes.size(); ++n) {
      builder.add_text_metric(fmt::format("files[0].notes[{}]", n), notes[n]);
    }
    std::ranges::move(builder.take_metrics(), std::back_inserter(solution.metrics));
    return solution;
  };
  return {
      .identity = make_external_density_identity(external, transform::kExternalFile, "from a file"),
      .solve = solve,
      .check = [check](const problem::Problem& problem) { check(problem); }};
}

}  // namespace fpkcheck::methods
