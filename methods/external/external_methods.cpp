#include "methods/external/external_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/external/density_file.hpp"
#include "methods/external/external_argument.hpp"
#include "methods/external/external_density.hpp"
#include "methods/external/external_joint.hpp"
#include "methods/external/external_labels.hpp"
#include "methods/external/external_marginal.hpp"
#include "methods/external/external_samples.hpp"
#include "methods/external/joint_table.hpp"
#include "methods/external/range_between_walls.hpp"
#include "problem/balances.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::methods {
namespace {

using transform::StateVariable;

double unknown_value() { return std::numeric_limits<double>::quiet_NaN(); }

// Returns a note on the probability mass outside the comparison axes, which the comparison ignores.
std::optional<std::string> outside_mass_note(const ExternalMarginal& marginal, double share,
                                             const std::vector<double>& bins) {
  constexpr double kSmall = 1e-3;
  if (share <= kSmall) return std::nullopt;
  return fmt::format(
      "{:.3g} % of the mass is outside the comparison axes, {} = {:.3g} to {:.3g}, and ignored; "
      "check the units",
      100 * share, marginal.variable() == StateVariable::y ? "y" : "y'", bins.front(), bins.back());
}

// Adds the properties of a density file and its normalisation as metrics under "files[k]".
void add_metrics(const ExternalMarginal& marginal, const std::vector<double>& bins, double mass,
                 double min_density, std::size_t k, transform::SolverMetricsBuilder& builder) {
  const std::string path = fmt::format("files[{}].", k);
  const MarginalFileSummary& file = marginal.file();
  const double beyond = marginal.mass_fraction_outside(bins.front(), bins.back());
  builder.add_text_metric(path + "file", file.path)
      .add_text_metric(path + "variable", std::string(name(marginal.variable())))
      .add_text_metric(path + "form", file.form)
      .add_diagnostic_metric(path + "rows", transform::value_from_count(file.rows));
  if (!file.values.empty()) builder.add_text_metric(path + "values", file.values);
  builder.add_result_metric(path + "from", file.from)
      .add_result_metric(path + "to", file.to)
      .add_result_metric(path + "integral", file.integral);
  if (file.divided_by) builder.add_result_metric(path + "normalised_by", *file.divided_by);
  auto notes = file.notes;
  if (const auto note = outside_mass_note(marginal, beyond, bins)) notes.push_back(*note);
  if (notes.empty()) builder.add_empty_list(path + "notes", transform::SolverMetricKind::text);
  for (std::size_t n = 0; n < notes.size(); ++n) {
    builder.add_text_metric(fmt::format("{}notes[{}]", path, n), notes[n]);
  }
  builder.add_result_metric(path + "mass", mass)
      .add_result_metric(path + "min_density", min_density)
      .add_result_metric(path + "beyond_axes", beyond);
}

void add_sampling_error(const ExternalMarginal& marginal, const std::vector<double>& bins,
                        transform::Solution& solution) {
  if (!marginal.has_standard_errors()) return;
  const auto [expected, quantile_99] = marginal.l1_sampling_error(bins);
  auto& sampling = solution.sampling ? *solution.sampling : solution.sampling.emplace();
  const bool of_y = marginal.variable() == StateVariable::y;
  (of_y ? sampling.y : sampling.ydot) = expected;
  (of_y ? sampling.y_99 : sampling.ydot_99) = quantile_99;
}

// Returns the residual of the virial balance in wall coordinates, if both marginal densities are
// known. The momentum balance is omitted, since the momentum balance requires wall fluxes and joint
// moments.
transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const std::vector<ExternalMarginal>& marginals) {
  const auto of = [&](StateVariable variable) {
    return std::ranges::find(marginals, variable, &ExternalMarginal::variable);
  };
  const auto y = of(StateVariable::y), ydot = of(StateVariable::ydot);
  if (y == marginals.end() || ydot == marginals.end()) return {};
  const problem::System& system = problem.system;
  if (!system.has_polynomial_force()) return {};
  if ((system.left_wall() && system.right_wall()) || system.rayleigh_coefficient() != 0) return {};
  const problem::WallFrame frame = problem::wall_frame(system);
  const problem::Problem transformed = problem::to_wall_coordinates(frame, problem);
  // The substitution of the wall coordinate x(y) converts a polynomial in x to a polynomial in y.
  const auto in_y = [&](const numerics::Polynomial& of_x) {
    return of_x.compose_affine(frame.inverse_frame().origin, frame.velocity_sign());
  };
  const auto virial = in_y(transformed.system.restoring_force().multiplied_by_argument());
  double mean_virial = virial.coefficient(0) * y->moment(0);
  for (std::size_t n = 1; n <= virial.degree(); ++n) {
    if (virial.coefficient(n) == 0) continue;
    mean_virial += virial.coefficient(n) * y->moment(static_cast<int>(n));
  }
  return {.virial = problem::virial_balance(
                        transformed, {.mean_displacement = frame.wall_coordinate(y->moment(1)),
                                      .mean_square_velocity = ydot->moment(2),
                                      .mean_virial = mean_virial})
                        .relative_balance_residual()};
}

transform::Solution marginals_solution(const problem::Problem& problem,
                                       const std::vector<ExternalMarginal>& marginals,
                                       const compare::ComparisonBins& axes) {
  transform::Solution solution;
  solution.status = transform::Status::ok;
  solution.energy_residual = unknown_value();
  auto& m = solution.moments;
  m = {unknown_value(), unknown_value(), unknown_value(),
       unknown_value(), unknown_value(), unknown_value()};
  transform::SolverMetricsBuilder builder;
  for (std::size_t k = 0; k < marginals.size(); ++k) {
    const auto& marginal = marginals[k];
    const bool of_y = marginal.variable() == StateVariable::y;
    (of_y ? m.y1 : m.v1) = marginal.moment(1);
    (of_y ? m.y2 : m.v2) = marginal.moment(2);
    (of_y ? m.y4 : m.v4) = marginal.moment(4);
    const auto& bins = compare::comparison_bin_edges(axes, marginal.variable());
    auto on_axes = marginal.average_over_bins(bins);
    const double mass = marginal.moment(0);
    const auto [least, most] = std::ranges::minmax(on_axes.density);
    const double min_density = most > 0 ? least / most : 0;
    // For a solution with several density files, the mass of the solution is the mass that differs
    // most from 1, and the minimum density is the smallest minimum.
    if (k == 0 || std::abs(mass - 1) > std::abs(solution.mass - 1)) solution.mass = mass;
    if (k == 0 || min_density < solution.min_density) solution.min_density = min_density;
    add_sampling_error(marginal, bins, solution);
    add_metrics(marginal, bins, mass, min_density, k, builder);
    solution.estimated_marginals.emplace_back(marginal.variable(), std::move(on_axes));
  }
  add_balance_metrics(builder, balance_residuals(problem, marginals));
  add_rest_atom_note(problem, builder);
  solution.metrics = builder.take_metrics();
  return solution;
}

// A file with a marginal density. The ExternalMarginal of a file is built later, when the walls of
// the case are known.
struct MarginalFile {
  NumberTable table;
  StateVariable variable;
};

std::vector<ExternalMarginal> read_marginals(const problem::Problem& problem,
                                             const std::vector<MarginalFile>& files) {
  std::vector<ExternalMarginal> marginals;
  for (const auto& file : files) marginals.emplace_back(file.table, problem.system.walls());
  return marginals;
}

struct DensityFilesWithLabel {
  ExternalDensity external;
  std::vector<MarginalFile> marginals;
  std::optional<ExternalJointDensity> joint;
  std::optional<StateSamples> samples;
};

// Sets the density equation, impact condition and order of an external density from the argument of
// --against. A setting that is missing in the argument of --against is taken from the density file.
void set_identity(const ExternalDensityArgument& argument, const ExternalJointDensity* joint,
                  ExternalDensity& external) {
  const auto differ = [&](const char* what) {
    throw InputError(fmt::format("the files of '{}' have different {}s; give the same for all",
                                 external.label, what));
  };
  auto equation = argument.equation;
  auto impact = argument.impact;
  auto order = argument.order;
  if (joint != nullptr) {
    if (!equation) {
      equation = joint->equation;
      impact = joint->impact;
    }
    if (!order) order = joint->order;
  }
  if (equation) {
    const auto own_impact = impact.value_or(problem::ImpactCondition::map);
    if (external.equation && (*external.equation != *equation || external.impact != own_impact))
      differ("equation");
    external.equation = equation;
    external.impact = own_impact;
  }
  if (argument.is_reference) external.is_reference = true;
  if (order) {
    if (external.order && *external.order != *order) differ("order");
    external.order = order;
  }
}

void add_marginal(NumberTable table, DensityFilesWithLabel& given) {
  const StateVariable variable = ExternalMarginal(table, {}).variable();
  if (std::ranges::find(given.marginals, variable, &MarginalFile::variable) !=
      given.marginals.end()) {
    throw InputError(
        fmt::format("two files of '{}' are densities of {}; give one file another label",
                    given.external.label, variable == StateVariable::y ? "y" : "y'"));
  }
  given.marginals.push_back({std::move(table), variable});
}

StateSamples read_samples(const ExternalDensityArgument& argument, DensityFileFormat format,
                          std::string bytes) {
  const std::string source = argument.file.string();
  if (format != DensityFileFormat::text) {
    throw InputError(
        fmt::format("{} has no columns of samples; omit the key samples", base::in_quotes(source)));
  }
  std::istringstream in(std::move(bytes));
  StateSamples samples =
      samples_from_table(read_number_table(in, source, NumberTableContent::samples));
  samples.is_time_series = *argument.samples == SampleRelation::series;
  return samples;
}

void read_density_into(const ExternalDensityArgument& argument, const std::string& case_name,
                       const SolverRegistry& registry, DensityFilesWithLabel& given) {
  auto [form, bytes] = read_density_file(argument.file);
  std::optional<ExternalJointDensity> joint;
  std::optional<StateSamples> samples;
  if (argument.samples) {
    samples = read_samples(argument, form, std::move(bytes));
  } else if (form == DensityFileFormat::netcdf) {
    joint = joint_density_from_netcdf(argument, std::move(bytes), case_name, registry);
  } else if (form == DensityFileFormat::json) {
    joint = joint_density_from_json(argument, bytes, case_name);
  } else {
    if (argument.solution || argument.case_name) {
      throw InputError(fmt::format("{} contains a single density; omit the key {}",
                                   base::in_quotes(argument.file.string()),
                                   argument.solution ? "solution" : "case"));
    }
    std::istringstream in(std::move(bytes));
    auto table = read_number_table(in, argument.file.string());
    if (is_joint_density(table)) {
      joint = joint_density_from_table(table);
    } else {
      add_marginal(std::move(table), given);
    }
  }
  if (given.joint || given.samples || ((joint || samples) && !given.marginals.empty())) {
    throw InputError(fmt::format(
        "two files of '{}', one of them a joint density or samples; give one file another label",
        given.external.label));
  }
  set_identity(argument, joint ? &*joint : nullptr, given.external);
  given.joint = std::move(joint);
  given.samples = std::move(samples);
}

Method make_marginals_method(const ExternalDensity& external,
                             const std::vector<MarginalFile>& files) {
  return {
      .identity = make_external_density_identity(external, transform::kExternalFile, "from a file"),
      .solve =
          [files](const problem::Problem& problem, const SolverInputContext& context) {
            return marginals_solution(problem, read_marginals(problem, files), context.axes);
          },
      .check = [files](const problem::Problem& problem) { read_marginals(problem, files); }};
}

}  // namespace

std::vector<Method> external_density_methods_from_files(std::span<const std::string> arguments,
                                                        const SolverRegistry& registry,
                                                        const std::string& case_name) {
  std::vector<DensityFilesWithLabel> solutions;
  for (const auto& text : arguments) {
    auto argument = parse_external_argument(text);
    if (argument.solution && !argument.has_label) argument.label = "given-" + *argument.solution;
    const std::string& label = argument.label;
    require_valid_label(label, registry);
    const auto label_of = [](const DensityFilesWithLabel& given) { return given.external.label; };
    auto external = std::ranges::find(solutions, label, label_of);
    for (const auto& given : solutions) require_distinct_labels(given.external.label, label);
    if (external == solutions.end()) {
      external =
          solutions.insert(external, {{.label = label, .index = solutions.size()}, {}, {}, {}});
    }
    read_density_into(argument, case_name, registry, *external);
  }
  std::vector<Method> methods;
  for (auto& [external, marginals, joint, samples] : solutions) {
    methods.push_back(joint     ? make_method_from_joint_density(external, *joint)
                      : samples ? make_method_from_samples(external, transform::kExternalFile,
                                                           *std::move(samples))
                                : make_marginals_method(external, marginals));
  }
  group_methods_into_families(methods);
  return methods;
}

}  // namespace fpkcheck::methods
