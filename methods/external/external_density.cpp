#include "methods/external/external_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/input_error.hpp"
#include "methods/plot_style.hpp"
#include "problem/balances.hpp"
#include "problem/problem_features.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Moments;
using transform::Solution;
using transform::Status;

// The tolerances of negative values and of values at the outermost edges are relative to the peak
// of the density. The tolerance of the mass of a closure is relative to a mass of 1.
constexpr double kNegativeTolerance = 1e-6, kCutOffTolerance = 1e-4, kClosureMassTolerance = 1e-3;

// Returns the largest average of a density among the outermost cells, except cells at a wall.
double largest_boundary_average(const transform::GridDensity& grid,
                                const DensityQuadratureGrid& points) {
  double most = 0;
  for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
    most = std::max({most, grid.cell_average(i, 0), grid.cell_average(i, grid.v_cell_count() - 1)});
  }
  for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
    if (!points.has_wall_at_start()) most = std::max(most, grid.cell_average(0, j));
    if (!points.has_wall_at_end())
      most = std::max(most, grid.cell_average(grid.y_cell_count() - 1, j));
  }
  return most;
}

// Returns the outermost edges of the cells as text: "at y = 2 and |y'| = 3".
std::string cut_off_text(const transform::GridDensity& grid, const DensityQuadratureGrid& points) {
  std::string ends;
  if (!points.has_wall_at_start()) ends += fmt::format("y = {:.3g}, ", grid.y_edges.front());
  if (!points.has_wall_at_end()) ends += fmt::format("y = {:.3g}, ", grid.y_edges.back());
  if (!ends.empty()) ends.replace(ends.size() - 2, 2, " and ");
  return fmt::format("at {}|y'| = {:.3g}", ends, grid.v_edges.back());
}

// Returns the reason for the status `inadmissible`; empty for an admissible density.
std::string inadmissible_reason(const transform::GridDensity& grid,
                                const DensityQuadratureGrid& points, double peak, double least,
                                double mass) {
  if (least < -kNegativeTolerance * peak) {
    return fmt::format("the density is negative, down to {:.1e} of its peak", least / peak);
  }
  const double end = largest_boundary_average(grid, points);
  if (end > kCutOffTolerance * peak) {
    return fmt::format("the density is cut off at {:.1e} of its peak (limit {:.0e}), {}",
                       end / peak, kCutOffTolerance, cut_off_text(grid, points));
  }
  if (std::abs(mass - 1) > kClosureMassTolerance)
    return fmt::format("the integral is {:.6g}, not 1", mass);
  return {};
}

// Returns the residuals of the virial balance and the momentum balance, in wall coordinates.
transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const DensityIntegrals& integrals, double mass) {
  const problem::WallFrame frame = problem::wall_frame(problem.system);
  const problem::Problem transformed = problem::to_wall_coordinates(frame, problem);
  const problem::System& system = transformed.system;
  // For a force formula the balances contain the whole force f + g (VirialBalanceTerms).
  const auto force = [&](double x, double v) {
    return system.force(x, system.has_polynomial_force() ? 0 : v);
  };
  const auto mean = [&](const auto& function) {
    return integrals.integrate_times_density([&](double y, double v) {
      return function(frame.wall_coordinate(y), frame.physical_velocity(v));
    }) / mass;
  };
  const auto wall_momentum = [&](bool right) {
    const auto& wall = right ? problem.system.right_wall() : problem.system.left_wall();
    if (!wall) return 0.0;
    const auto change = [&](double u) { return problem::momentum_change_at_impact(*wall, u); };
    return (right ? integrals.sum_over_right_impacts(change)
                  : integrals.sum_over_left_impacts(change)) /
           mass;
  };
  const problem::VirialBalanceTerms virial{
      .mean_displacement = mean([](double x, double) { return x; }),
      .mean_square_velocity = mean([](double, double v) { return v * v; }),
      .mean_virial = mean([&](double x, double v) { return x * force(x, v); }),
      .right_impact_momentum = frame.mirrored ? 0 : wall_momentum(true),
      .mean_y_cubed_velocity = mean([](double x, double v) { return x * v * v * v; })};
  problem::MomentumBalanceTerms momentum{
      .mean_force = mean(force),
      .left_impact_momentum = wall_momentum(frame.mirrored),
      .right_impact_momentum = virial.right_impact_momentum,
      .mean_cubed_velocity = mean([](double, double v) { return v * v * v; }),
      .mean_absolute_force = mean([&](double x, double) { return std::abs(system.force(x, 0)); })};
  transform::BalanceResiduals residuals{
      .virial = problem::virial_balance(transformed, virial).relative_balance_residual()};
  // For impulses with mean zero and a system without a wall, both sides of the momentum balance are
  // 0.
  const bool has_mean_impulse = problem.impulses.rate_times_moment(1) != 0;
  if (problem.system.left_wall() || problem.system.right_wall() || has_mean_impulse) {
    residuals.momentum =
        problem::momentum_balance(transformed, momentum).relative_balance_residual();
  }
  return residuals;
}

}  // namespace

transform::SolutionIdentity make_external_density_identity(const ExternalDensity& external,
                                                           std::string_view method,
                                                           const std::string& origin) {
  transform::SolutionIdentity identity{.id = external.label,
                                       .method = std::string(method),
                                       .order = external.order,
                                       .role = transform::SolutionRole::external,
                                       .family = std::string(method),
                                       .trust = static_cast<int>(external.index),
                                       .plot_style = external_density_style(external.index)};
  if (external.is_reference && external.equation) {
    throw InputError(fmt::format(
        "'{}': a reference approximates no equation; omit the equation or the role of reference",
        external.label));
  }
  if (external.is_reference) {
    identity.role = transform::SolutionRole::measurement;
    identity.meaning = fmt::format("The reference: an external density, {}.", origin);
  } else if (external.equation) {
    identity.role = transform::SolutionRole::closure;
    identity.equation = external.equation;
    identity.impact = external.impact;
    identity.meaning = fmt::format("An external density, {}.", origin);
  } else {
    identity.meaning =
        fmt::format("An external density, {}; its equation and impact are unknown.", origin);
  }
  return identity;
}

void add_rest_atom_note(const problem::Problem& problem, transform::SolverMetricsBuilder& builder) {
  if (!problem::problem_features(problem).rests_in_contact) return;
  builder.add_text_metric(
      "notes[0]",
      "the mass at rest in contact with a wall is not part of the density and counts as missing");
}

double validated_density_integral(const ExternalDensity& external,
                                  const DensityQuadratureGrid& points,
                                  const std::vector<double>& values) {
  const std::size_t nv = points.v_points().size();
  if (values.size() != points.y_points().size() * nv) {
    throw InputError(fmt::format("density '{}': {} values (must be {} x {})", external.label,
                                 values.size(), points.y_points().size(), nv));
  }
  const auto bad = std::ranges::find_if(values, [](double p) { return !std::isfinite(p); });
  if (bad != values.end()) {
    const auto k = static_cast<std::size_t>(bad - values.begin());
    throw InputError(fmt::format("density '{}': p({:.4g}, {:.4g}) is {} (must be a finite number)",
                                 external.label, points.y_points()[k / nv],
                                 points.v_points()[k % nv], *bad));
  }
  const double mass = DensityIntegrals(points, values).mass();
  if (!(mass > 0) || !std::isfinite(mass)) {
    throw InputError(fmt::format("density '{}': the integral is {:.4g} (must be positive)",
                                 external.label, mass));
  }
  return mass;
}

Solution make_external_density_solution(const problem::Problem& problem,
                                        const SolverInputContext& context,
                                        const ExternalDensity& external,
                                        const JointDensityOptions& options,
                                        const DensityQuadratureGrid& points,
                                        std::vector<double> values, double mass) {
  if (options.normalise) {
    for (double& value : values) value /= mass;
  }
  const DensityIntegrals integrals(points, values);
  const auto [least, peak] = std::ranges::minmax(values);
  Solution solution;
  auto grid = integrals.cell_averages();
  solution.mass = integrals.mass();
  solution.min_density = least / peak;
  solution.moments = integrals.moments(solution.mass);
  const auto& moments = solution.moments;
  const problem::System& system = problem.system;
  const double damping_power = integrals.integrate_times_density(
      [&](double y, double v) { return v * system.damping_force(y, v); });
  const auto loss = [&](const std::optional<problem::Wall>& wall) {
    return [&](double u) { return problem::energy_loss_at_impact(*wall, external.impact, u); };
  };
  const double left_loss = integrals.sum_over_left_impacts(loss(system.left_wall()));
  const double right_loss = integrals.sum_over_right_impacts(loss(system.right_wall()));
  const double square_noise_factor = integrals.integrate_times_density([&](double y, double v) {
    return problem.noise_factor ? problem.noise_factor->squared_noise_factor(y, v) : 1;
  });
  const double square_impulse_factor = integrals.integrate_times_density(
      [&](double y, double) { return problem::squared_impulse_factor(problem, y); });
  solution.energy_residual = problem::power_balance_residual(
      problem, {.mean_velocity = moments.v1,
                .mean_square_velocity = moments.v2,
                .left_impact_loss = left_loss / solution.mass,
                .right_impact_loss = right_loss / solution.mass,
                .mean_damping_power = damping_power / solution.mass,
                .mean_square_noise_factor = square_noise_factor / solution.mass,
                .mean_square_impulse_factor = square_impulse_factor / solution.mass});
  solution.reason = options.inadmissible_reason.empty()
                        ? inadmissible_reason(grid, points, peak, least, solution.mass)
                        : options.inadmissible_reason;
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  solution.density = std::move(grid);

  transform::SolverMetricsBuilder builder;
  if (options.normalise) builder.add_result_metric("normalised_by", mass);
  add_balance_metrics(builder, balance_residuals(problem, integrals, solution.mass));
  add_rest_atom_note(problem, builder);
  solution.metrics = builder.take_metrics();
  if (external.equation && context.error_estimator != nullptr) {
    // The reason of the status has no prefix, since an external density was not tested against its
    // equations.
    set_residual_error_estimate(*context.error_estimator, options.accuracy, solution, {}, "");
  }
  return solution;
}

Method make_method_from_density_values(const ExternalDensity& external,
                                       const JointDensityOptions& options,
                                       const DensityQuadratureGrid& points,
                                       std::vector<double> values) {
  const double mass = validated_density_integral(external, points, values);
  return {.identity = make_external_density_identity(external, transform::kExternalFunction,
                                                     "given as a function"),
          .solve = [external, options, points, mass, values = std::move(values)](
                       const problem::Problem& problem, const SolverInputContext& context) {
            return make_external_density_solution(problem, context, external, options, points,
                                                  values, mass);
          }};
}

}  // namespace fpkcheck::methods
