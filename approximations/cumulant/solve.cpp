#include "approximations/cumulant/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "approximations/cumulant/bivariate_polynomial.hpp"
#include "approximations/cumulant/moment_equations.hpp"
#include "base/process/stopwatch.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/difference_jacobian.hpp"
#include "numerics/statistics.hpp"
#include "problem/motion_scales.hpp"
#include "transform/smooth_density_results.hpp"

namespace fpkcheck::cumulant {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using transform::Status;

// Half-width of the domain in standard deviations. Outside, moments of the orders up to 6 of
// Gram-Charlier densities have relative contributions below 1e-12.
constexpr double kDomainDeviations = 12;

transform::SmoothDensity smooth_density(const Cumulants& cumulants, bool has_wall) {
  const double mean = cumulants.mean_displacement, s_y = cumulants.displacement_deviation,
               s_v = cumulants.velocity_deviation;
  const double unit = (has_wall ? 2 : 1) / (s_y * s_v);
  return {.value =
              [=, polynomial = gram_charlier_polynomial(cumulants)](double y, double v) {
                const double x = (y - mean) / s_y, w = v / s_v;
                return unit * numerics::normal_density(x) * numerics::normal_density(w) *
                       evaluate_polynomial(polynomial, x, w);
              },
          .y_max = mean + kDomainDeviations * s_y,
          .v_max = kDomainDeviations * s_v,
          .y_min = has_wall ? 0 : mean - kDomainDeviations * s_y};
}

// Returns the smallest value of a density, relative to its largest value, on a grid of points at
// distances of 0.05 standard deviations.
double relative_minimum(const Cumulants& cumulants) {
  constexpr double kSpacing = 0.05;
  const int points = static_cast<int>(kDomainDeviations / kSpacing);
  const MatrixXd polynomial = gram_charlier_polynomial(cumulants);
  double smallest = 0, largest = 0;
  for (int i = -points; i <= points; ++i) {
    for (int j = -points; j <= points; ++j) {
      const double x = i * kSpacing, w = j * kSpacing;
      const double value = numerics::normal_density(x) * numerics::normal_density(w) *
                           evaluate_polynomial(polynomial, x, w);
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  return smallest / largest;
}

// A search for a root of the moment equations.
struct RootSearch {
  std::optional<VectorXd> root = {};
  std::string failure = {};
  int newton_steps = 0;
  bool by_continuation = false;
};

std::string_view termination_text(numerics::ContinuationTermination end) {
  using enum numerics::ContinuationTermination;
  if (end == fell_back) return "turns back";
  if (end == diverged) return "diverges";
  return end == limit_exceeded ? "reaches the limit of steps" : "ends";
}

RootSearch find_root(const MomentEquations& moment_equations, const VectorXd& start, int order) {
  const auto residuals_at = [&](const VectorXd& a) { return moment_equations.residuals_at(a); };
  const numerics::EquationsWithDifferenceJacobian equations(residuals_at);
  const numerics::NewtonOptions newton_options{};
  RootSearch search;
  auto newton = numerics::solve_by_newton(equations, start, newton_options);
  search.newton_steps = newton.iterations;
  if (!newton.converged) {
    const auto curve = numerics::trace_solution_curve(
        numerics::newton_homotopy(
            residuals_at, [&](const VectorXd& a) { return equations.jacobian_at(a); }, start),
        start, {});
    search.newton_steps += curve.iterations;
    search.by_continuation = true;
    newton = numerics::solve_by_newton(equations, curve.points.back().a, newton_options);
    search.newton_steps += newton.iterations;
    if (!newton.converged) {
      search.failure = fmt::format(
          "no solution of the moment equations of order {}: the branch of solutions from the start "
          "{} at {} % of the homotopy; use fd or mcs",
          order, termination_text(curve.end),
          std::floor(100 * std::max(0.0, curve.curve_point_with_largest_parameter().t)));
      return search;
    }
  }
  search.root = newton.a;
  return search;
}

void store_solution(const problem::Problem& problem, const CumulantOptions& options,
                    const Cumulants& cumulants, transform::SolverMetricsBuilder& metrics,
                    transform::Solution& solution) {
  const bool has_wall = problem.system.left_wall().has_value();
  const auto results = transform::store_smooth_density(
      problem, options.impact, smooth_density(cumulants, has_wall), solution);
  // Rounding errors of a density, relative to its largest value
  constexpr double kRounding = 1e-12;
  solution.min_density = relative_minimum(cumulants);
  solution.status = Status::ok;
  if (solution.min_density < -kRounding) {
    solution.status = Status::inadmissible;
    solution.reason = fmt::format(
        "the Gram-Charlier density is negative, down to {:.1e} of its peak; only the moments are "
        "meaningful",
        solution.min_density);
  }
  int count = 0;
  for (int order = 3; order <= options.order; ++order) {
    for (int p = order; p >= 0; --p) {
      const int q = order - p;
      if (q == 1 || (has_wall && order % 2 == 1)) continue;
      const std::string path = fmt::format("standardised_cumulants[{}].", count++);
      metrics.add_result_metric(path + "y", transform::value_from_count(p))
          .add_result_metric(path + "v", transform::value_from_count(q))
          .add_result_metric(path + "value", cumulants.standardised(p, q));
    }
  }
  transform::add_balance_metrics(metrics, results.balances);
}

}  // namespace

transform::Solution solve_moment_equations(const problem::Problem& problem,
                                           const CumulantOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  const problem::MotionScales scales = problem::motion_scales(problem);
  const auto coefficients = polynomial_coefficients(problem, scales);
  assert(coefficients);
  MatrixXd gaussian = MatrixXd::Zero(3, 3);
  gaussian(2, 0) = gaussian(0, 2) = 1;
  Cumulants cumulants{.mean_displacement = problem.system.left_wall() ? 0 : scales.centre,
                      .displacement_deviation = coefficients->displacement_unit,
                      .velocity_deviation = coefficients->velocity_unit,
                      .standardised = gaussian};

  transform::Solution solution{.identity = solution_identity(options)};
  int newton_steps = 0;
  bool by_continuation = false;
  for (int order = 2; order <= options.order; order += 2) {
    const MomentEquations equations(problem, options.impact, *coefficients, order);
    const RootSearch search = find_root(equations, equations.unknowns_of(cumulants), order);
    newton_steps += search.newton_steps;
    by_continuation = by_continuation || search.by_continuation;
    if (!search.root) {
      solution.status = Status::not_converged;
      solution.reason = search.failure;
      break;
    }
    cumulants = equations.cumulants_of(*search.root);
  }
  transform::SolverMetricsBuilder metrics;
  if (solution.status != Status::not_converged) {
    store_solution(problem, options, cumulants, metrics, solution);
  }
  metrics.add_diagnostic_metric("newton_steps", transform::value_from_count(newton_steps))
      .add_diagnostic_metric("by_continuation", by_continuation);
  solution.metrics = metrics.take_metrics();
  solution.seconds = stopwatch.seconds();
  return solution;
}

std::string unsupported_reason(const problem::Problem& problem, const CumulantOptions&) {
  if (problem.system.right_wall()) {
    return "the image at one wall cannot represent two walls; use averaging, fd or mcs";
  }
  if (!polynomial_coefficients(problem, problem::motion_scales(problem))) {
    return "the moment equations need polynomials as force and factors; use linearisation, fd or "
           "mcs";
  }
  return "";
}

}  // namespace fpkcheck::cumulant
