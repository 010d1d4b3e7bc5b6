#include "backward/bounds/bounds_from_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_bounds.hpp"
#include "backward/generator/collocation.hpp"
#include "backward/generator/least_squares.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kPointsPerCell = 4;
constexpr double kRangeTolerance =
    0.03;  // relative tolerance of the residual range (docs/bounds.md)

std::vector<double> integrand_breaks(Axis axis, const std::vector<Functional>& functionals) {
  std::vector<double> points;
  for (const Functional& f : functionals) {
    if (axis_of(f) != axis) continue;
    const std::vector<double> own = non_smooth_points(f);
    points.insert(points.end(), own.begin(), own.end());
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Returns bounds of the mean E[f] of an integrand f from the approximate mean U and the range of
// the residual: U + least E[tau] <= E[f] <= U + largest E[tau], for least <= 0 <= largest.
numerics::Enclosure mean_enclosure(double mean, const ResidualRange& range, double outside,
                                   const ResidualWeight& weight) {
  const numerics::Interval tau = weight.mean_bound;
  // If the range of the residual contains NaN or infinity, no bound exists.
  if (!std::isfinite(range.least) || !std::isfinite(range.largest) || !std::isfinite(outside)) {
    return {-HUGE_VAL, HUGE_VAL};
  }
  const double least = std::min(range.least, -outside), largest = std::max(range.largest, outside);
  return {(numerics::Interval(mean) + numerics::Interval(least) * tau).lower(),
          (numerics::Interval(mean) + numerics::Interval(largest) * tau).upper()};
}

}  // namespace

std::vector<numerics::Enclosure> bounds_from_grid(const problem::Problem& problem,
                                                  const ResidualWeight& weight,
                                                  const SplineGrid& grid,
                                                  const std::vector<Functional>& functionals,
                                                  int threads, SplineGridReport* report) {
  const base::Stopwatch stopwatch;
  const numerics::SplineBasis displacement =
      displacement_spline_basis(grid, weight, problem.system);
  const BoxEndTypes ends = box_end_types(displacement, problem.system);
  const ImpactBasis velocity = velocity_spline_basis(grid, weight, problem.system.restitution());
  const std::vector<double> y_cuts = integrand_breaks(Axis::displacement, functionals),
                            v_cuts = integrand_breaks(Axis::velocity, functionals);
  const VelocityFactorEnclosures v_operators = numerics::call_with_upward_rounding(
      [&] { return enclose_velocity_factors(problem, velocity, v_cuts); });
  const DisplacementFactorEnclosures y_operators = numerics::call_with_upward_rounding(
      [&] { return enclose_displacement_factors(problem, displacement, y_cuts); });
  const double tabulated = stopwatch.seconds();

  const DisplacementSplineSamples y = sample_displacement_splines(displacement, kPointsPerCell);
  const VelocityFactorSamples v = sample_velocity_factors(v_operators, velocity, kPointsPerCell);
  std::vector<std::function<double(double, double)>> integrands;
  for (const Functional& f : functionals) {
    integrands.emplace_back(
        [&](double at, double speed) { return integrand(f, problem, at, speed); });
  }
  const BackwardSolutions solutions = solve_backward_equations(
      {problem, displacement, velocity, y, v,
       [&](double at, double speed) {
         return 1 / (1 + std::pow(weight.energy(at, speed) / weight.scale, weight.power / 2.0));
       },
       [&](double at, double speed) { return 1 / weight(at, speed); }, ends.left_wall,
       ends.right_wall},
      integrands);
  const double fitted = stopwatch.seconds();

  const CertificateCheckInputs context{problem,     displacement, velocity, y_operators,
                                       v_operators, weight,       ends};
  std::vector<numerics::Enclosure> bounds(functionals.size());
  std::vector<SplineGridReport::FunctionalResidual> each(functionals.size());
  base::parallel_for(functionals.size(), threads, [&](std::size_t i) {
    numerics::call_with_upward_rounding([&] {
      const Certificate certificate{solutions.coefficients[i], solutions.means[i]};
      const ResidualRange range = residual_range(context, functionals[i], certificate,
                                                 solutions.residual_extremes[i], kRangeTolerance);
      const double outside = outer_residual_bound(context, functionals[i], certificate);
      bounds[i] = enclose_functional(functionals[i], problem,
                                     mean_enclosure(certificate.mean, range, outside, weight));
      each[i] = {certificate.mean, range.least, range.largest, outside, range.boxes};
      return 0;
    });
  });
  if (report != nullptr) {
    *report = {displacement.size() * velocity.size() -
                   (ends.left_wall + ends.right_wall) * velocity.centre_index(),
               tabulated, fitted - tabulated, stopwatch.seconds() - fitted, std::move(each)};
  }
  return bounds;
}

}  // namespace fpkcheck::backward
