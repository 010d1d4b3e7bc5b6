#include "approximations/linearisation/solve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "approximations/linearisation/moment_equations.hpp"
#include "base/process/stopwatch.hpp"
#include "numerics/roots/difference_jacobian.hpp"
#include "problem/motion_scales.hpp"
#include "transform/smooth_density_results.hpp"

namespace fpkcheck::linearisation {
namespace {

using transform::Status;

transform::SmoothDensity smooth_density(const GaussianDensity& gaussian, bool has_wall) {
  const double mean = gaussian.mean_displacement, s_y = gaussian.displacement_deviation,
               s_v = gaussian.velocity_deviation;
  const double peak = (has_wall ? 2 : 1) / (2 * std::numbers::pi * s_y * s_v);
  return {.value =
              [=](double y, double v) {
                return peak * std::exp(-(std::pow((y - mean) / s_y, 2) + std::pow(v / s_v, 2)) / 2);
              },
          .y_max = mean + kDomainDeviations * s_y,
          .v_max = kDomainDeviations * s_v,
          .y_min = has_wall ? 0 : mean - kDomainDeviations * s_y};
}

}  // namespace

transform::Solution solve_moment_equations(const problem::Problem& problem,
                                           const LinearisationOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  const bool has_wall = problem.system.left_wall().has_value();
  const problem::MotionScales scales = problem::motion_scales(problem);
  // With a wall at y = 0, E[y^2] is the variance of z.
  const GaussianDensity start{
      .mean_displacement = has_wall ? 0 : scales.centre,
      .displacement_deviation = has_wall ? std::hypot(scales.centre, scales.displacement_deviation)
                                         : scales.displacement_deviation,
      .velocity_deviation = scales.velocity_deviation};
  const MomentEquations equations(problem, options.impact, start);
  const auto root = numerics::solve_by_newton(
      numerics::EquationsWithDifferenceJacobian(
          [&](const Eigen::VectorXd& unknowns) { return equations.residuals_at(unknowns); }),
      equations.unknowns_of(start), {});

  transform::Solution solution{.identity = solution_identity(options)};
  if (root.converged) {
    const GaussianDensity gaussian = equations.density_of(root.a);
    const auto results = transform::store_smooth_density(
        problem, options.impact, smooth_density(gaussian, has_wall), solution);
    solution.status = Status::ok;
    transform::SolverMetricsBuilder metrics;
    metrics.add_result_metric("gaussian.displacement_deviation", gaussian.displacement_deviation)
        .add_result_metric("gaussian.velocity_deviation", gaussian.velocity_deviation)
        .add_diagnostic_metric("newton_steps", transform::value_from_count(root.iterations));
    transform::add_balance_metrics(metrics, results.balances);
    solution.metrics = metrics.take_metrics();
  } else {
    solution.status = Status::not_converged;
    solution.reason = fmt::format(
        "Newton's method for mean and variances: residual {:.1e} after {} steps; the moment "
        "equations may have no Gaussian solution",
        root.residual, root.iterations);
  }
  solution.seconds = stopwatch.seconds();
  return solution;
}

std::string unsupported_reason(const problem::Problem& problem, const LinearisationOptions&) {
  if (!problem.system.right_wall()) return "";
  return "a Gaussian density cannot represent two walls; use averaging, fd or mcs";
}

}  // namespace fpkcheck::linearisation
