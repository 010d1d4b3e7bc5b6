#include "backward/bounds/bounds_from_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/backward_equation_fit.hpp"
#include "backward/generator/generator_at_collocation_points.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kPointsPerCell = 4;
// Relative tolerance of the computed range of the weighted residual (docs/bounds.md)
constexpr double kRangeTolerance = 0.03;

// Returns the points in increasing order at which integrands of a variable are not smooth.
std::vector<double> sorted_break_points(StateVariable variable,
                                        const std::vector<StationaryFunctional>& functionals) {
  std::vector<double> points;
  for (const StationaryFunctional& f : functionals) {
    if (integrand_variable(f) != variable) continue;
    const std::vector<double> break_points = integrand_breakpoints(f);
    points.insert(points.end(), break_points.begin(), break_points.end());
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Returns bounds of the mean E[f] of an integrand f from its approximate mean U and from bounds of
// the weighted residual inside and outside the box of the splines: The bounds are U + least E[tau]
// <= E[f] <= U + largest E[tau], with the weight tau and the range least .. largest of the weighted
// residual.
numerics::Enclosure enclose_integrand_mean(double approximate_mean,
                                           const BackwardResidualRange& range, double outside,
                                           const ResidualWeightFunctionOfEnergy& weight) {
  const numerics::Interval tau = weight.mean_upper_bound;
  // If the range of the weighted residual contains NaN or infinity, no bound of the mean exists.
  if (!std::isfinite(range.least) || !std::isfinite(range.largest) || !std::isfinite(outside)) {
    return {-HUGE_VAL, HUGE_VAL};
  }
  const double least = std::min(range.least, -outside), largest = std::max(range.largest, outside);
  return {(numerics::Interval(approximate_mean) + numerics::Interval(least) * tau).lower(),
          (numerics::Interval(approximate_mean) + numerics::Interval(largest) * tau).upper()};
}

}  // namespace

std::vector<numerics::Enclosure> compute_bounds_on_grid(
    const problem::Problem& problem, const ResidualWeightFunctionOfEnergy& weight,
    const SplineGrid& grid, const std::vector<StationaryFunctional>& functionals, int threads,
    SplineGridDiagnostics* diagnostics) {
  const base::Stopwatch stopwatch;
  const numerics::SplineBasis displacement =
      make_displacement_spline_basis(grid, weight, problem.system);
  const DisplacementBoundaryTypes displacement_ends =
      find_displacement_end_types(displacement, problem.system);
  const ImpactSplineBasis velocity =
      make_velocity_spline_basis(grid, weight, problem.system.restitution());
  const std::vector<double> y_cuts = sorted_break_points(StateVariable::y, functionals),
                            v_cuts = sorted_break_points(StateVariable::ydot, functionals);
  const GeneratorVelocityFactorEnclosures velocity_factors = numerics::call_with_upward_rounding(
      [&] { return enclose_velocity_factors(problem, velocity, v_cuts); });
  const GeneratorDisplacementFactorEnclosures displacement_factors =
      numerics::call_with_upward_rounding(
          [&] { return enclose_displacement_factors(problem, displacement, y_cuts); });
  const double enclosure_seconds = stopwatch.seconds();

  const DisplacementSplineSamples displacement_samples =
      sample_displacement_splines(displacement, kPointsPerCell);
  const GeneratorVelocityFactorSamples velocity_samples =
      sample_velocity_factors(velocity_factors, velocity, kPointsPerCell);
  std::vector<std::function<double(double, double)>> integrands;
  for (const StationaryFunctional& f : functionals) {
    integrands.emplace_back(
        [&](double y, double v) { return evaluate_integrand(f, problem, y, v); });
  }
  const BackwardEquationSolutions solutions = fit_backward_equation_solutions(
      {problem, displacement, velocity, displacement_samples, velocity_samples,
       [&](double y, double v) {
         return 1 /
                (1 + std::pow(weight.energy(y, v) / weight.energy_scale, weight.exponent / 2.0));
       },
       [&](double y, double v) { return 1 / weight(y, v); }, displacement_ends.has_left_wall,
       displacement_ends.has_right_wall},
      integrands);
  const double fit_end_seconds = stopwatch.seconds();

  const ResidualBoundInputs inputs{
      problem,          displacement, velocity,         displacement_factors,
      velocity_factors, weight,       displacement_ends};
  std::vector<numerics::Enclosure> bounds(functionals.size());
  std::vector<SplineGridDiagnostics::FunctionalResidual> functional_residuals(functionals.size());
  base::parallel_for(functionals.size(), threads, [&](std::size_t i) {
    numerics::call_with_upward_rounding([&] {
      const BoundCertificate certificate{solutions.spline_coefficients[i],
                                         solutions.mean_estimates[i]};
      const BackwardResidualRange range = enclose_residual_range(
          inputs, functionals[i], certificate, solutions.residual_extremes[i], kRangeTolerance);
      const double outside = outer_residual_bound(inputs, functionals[i], certificate);
      bounds[i] = enclose_functional(
          functionals[i], problem,
          enclose_integrand_mean(certificate.approximate_mean, range, outside, weight));
      functional_residuals[i] = {certificate.approximate_mean, range.least, range.largest, outside,
                                 range.box_count};
      return 0;
    });
  });
  if (diagnostics != nullptr) {
    *diagnostics = {displacement.size() * velocity.size() -
                        (displacement_ends.has_left_wall + displacement_ends.has_right_wall) *
                            velocity.basis_index_at_zero_velocity(),
                    enclosure_seconds, fit_end_seconds - enclosure_seconds,
                    stopwatch.seconds() - fit_end_seconds, std::move(functional_residuals)};
  }
  return bounds;
}

}  // namespace fpkcheck::backward
