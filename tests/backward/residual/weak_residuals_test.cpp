#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "backward/residual/weak_residuals.hpp"
#include "base/input_error.hpp"
#include "exact/linear_density.hpp"
#include "exact/linear_problem.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::backward {
namespace {

WeakResidualIntegrator make_coarse_integrator(const problem::Problem& problem) {
  return {problem,
          {numerics::QuinticBSplines(numerics::graded_knots(0, 6, 4, 14)),
           numerics::QuinticBSplines(numerics::graded_knots(-7, 7, 4, 28, 3))}};
}

/// A density without symmetry, whose value at the ends is 1e-11 of the peak.
double skew_bell(double y, double v) {
  return std::exp(-y * y - 0.8 * (v - 0.3) * (v - 0.3) - 0.4 * y * v) * (1 + 0.5 * y);
}
transform::SmoothDensity skew_density() { return {skew_bell, 6, 6.5}; }

/// Returns the value or the slope of one spline.
double evaluate_spline(const numerics::QuinticBSplines& splines, int i, double x,
                       bool slope = false) {
  const auto at = splines.values_and_slopes(x);
  if (i < at.first || i > at.first + numerics::QuinticBSplines::kDegree) return 0;
  return slope ? at.slope[static_cast<std::size_t>(i - at.first)]
               : at.value[static_cast<std::size_t>(i - at.first)];
}

/// The integral over [a, b], divided at the breaks of splines times `factor`.
double integrate_between_breaks(const std::function<double(double)>& f, double a, double b,
                                std::vector<double> breaks, double factor = 1) {
  for (double& x : breaks) x = std::clamp(factor * x, a, b);
  breaks.push_back(a);
  breaks.push_back(b);
  std::ranges::sort(breaks);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (breaks[k] < breaks[k + 1]) {
      sum += numerics::integrate_by_composite_gauss(f, breaks[k], breaks[k + 1], 2);
    }
  }
  return sum;
}

/// E[f(Y)] for a smooth f.
double mean_over_law(const problem::ImpulseLaw& law, const std::function<double(double)>& f) {
  double sum = 0;
  for (const auto& atom : law.amplitude_atoms()) sum += atom.probability * f(atom.amplitude);
  const auto pieces = law.amplitude_density_breakpoints();
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    sum += numerics::integrate_by_composite_gauss([&](double z) { return law.density(z) * f(z); },
                                                  pieces[k], pieces[k + 1], 12);
  }
  return sum;
}

/// rho_ij by its definition, for the unnormalised density above. The jump operator acts on p
/// instead of B_j: int p K B dv = int B(w) E[p(w - Y)] dw.
double weak_residual_by_definition(const problem::Problem& problem,
                                   const WeakResidualIntegrator& splines, int i, int j) {
  const numerics::QuinticBSplines &y_splines = splines.y_splines(),
                                  &v_splines = splines.v_splines();
  const auto& system = problem.system;
  const auto density = [](double y, double v) { return std::abs(v) < 6.5 ? skew_bell(y, v) : 0; };
  const auto integral_over_v = [&](double y) {
    const double a = evaluate_spline(y_splines, i, y),
                 slope = evaluate_spline(y_splines, i, y, true);
    if (a == 0 && slope == 0) return 0.0;
    return integrate_between_breaks(
        [&](double v) {
          const double b = evaluate_spline(v_splines, j, v),
                       of_b = evaluate_spline(v_splines, j, v, true);
          const double p = density(y, v);
          double sum = v * slope * b * p -
                       (system.damping() * v + system.restoring_force()(y)) * a * of_b * p -
                       problem.impulses.arrival_rate() * a * b * p;
          if (a != 0 && b != 0) {
            sum += problem.impulses.arrival_rate() * a * b *
                   mean_over_law(problem.impulses.amplitude_law(),
                                 [&](double z) { return skew_bell(y, v - z); });
          }
          return sum;
        },
        -7, 7, v_splines.breaks());
  };
  const double r = system.restitution();
  const double local = integrate_between_breaks(integral_over_v, 0, 6, y_splines.breaks());
  const double in = integrate_between_breaks(
      [&](double u) { return u * density(0, -u) * evaluate_spline(v_splines, j, -u); }, 0, 7,
      v_splines.breaks(), -1);
  const double out = integrate_between_breaks(
      [&](double u) { return u * density(0, -u) * evaluate_spline(v_splines, j, r * u); }, 0, 7,
      v_splines.breaks(), 1 / r);
  return local + evaluate_spline(y_splines, i, 0) * (out - in);
}

TEST(WeakResiduals, MatchTheirDefinitionForEveryLaw) {
  for (const char* law : tests::kSymmetricLaws) {
    const auto problem = tests::make_problem(
        {.damping = 0.3, .restitution = 0.7, .rate = 1.7, .mean = 0.1, .law = law});
    const auto integrator = make_coarse_integrator(problem);
    const auto integrals = integrator.integrate_density(skew_density());
    // Indices of functions at the wall (incoming, outgoing and at v = 0), inside, and of the last
    // function of y.
    for (const auto& [i, j] : {std::pair{0, 13}, {0, 19}, {0, 16}, {4, 12}, {7, 20}, {1, 18}}) {
      EXPECT_NEAR(integrals.mass * integrals.weak_residuals(i, j),
                  weak_residual_by_definition(problem, integrator, i, j), 1e-8)
          << law << ' ' << i << ' ' << j;
      EXPECT_GT(std::abs(integrals.weak_residuals(i, j)), 1e-5) << i << ' ' << j;
    }
  }
}

TEST(WeakResiduals, OfCellAveragesAreThoseOfTheFunction) {
  // Different cell widths for v < 0 and v > 0.
  const auto integrator =
      make_coarse_integrator(tests::make_problem({.restitution = 0.7, .mean = 0.1}));
  auto v = tests::uniform_edges(-6.5, 0, 100);
  for (const double edge : tests::uniform_edges(0, 6.5, 80)) {
    if (edge > 0) v.push_back(edge);
  }
  const auto grid =
      transform::average_over_cells(skew_density(), tests::uniform_edges(0, 6, 90), v);
  const auto of_grid = integrator.integrate_density(grid),
             of_function = integrator.integrate_density(skew_density());
  EXPECT_LT((of_grid.weak_residuals - of_function.weak_residuals).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((of_grid.spline_means - of_function.spline_means).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(of_grid.mass, transform::mass(grid), 1e-13);
}

TEST(WeakResiduals, SumToZeroAndMeansToOne) {
  for (const char* law : tests::kSymmetricLaws) {
    const auto problem = tests::make_problem({.restitution = 0.7, .mean = 0.1, .law = law});
    const auto integrals = make_coarse_integrator(problem).integrate_density(skew_density());
    EXPECT_NEAR(integrals.weak_residuals.sum(), 0, 1e-14) << law;
    EXPECT_GT(integrals.weak_residuals.cwiseAbs().sum(), 0.1);
    EXPECT_NEAR(integrals.spline_means.sum(), 1, 1e-14);
  }
}

TEST(WeakResiduals, OfPowersAreTheBalances) {
  // L y = v and L v = -c v - g(y) + lambda E[Y]; impacts change v by (1 + r) u.
  const auto problem = tests::make_problem({.restitution = 0.7, .mean = 0.1});
  const auto integrator = make_coarse_integrator(problem);
  const auto p = skew_density();
  const auto integrals = integrator.integrate_density(p);
  const auto of_y = integrator.y_splines().coefficients_of_monomial(1),
             of_v = integrator.v_splines().coefficients_of_monomial(1);
  const Eigen::Map<const Eigen::VectorXd> y(of_y.data(), std::ssize(of_y)),
      v(of_v.data(), std::ssize(of_v));
  const auto& m = integrals.moments;
  EXPECT_NEAR(y.dot(integrals.weak_residuals.rowwise().sum()), m.v1, 1e-9);
  const auto mean = [&](const std::function<double(double, double)>& g) {
    return transform::expectation(p, g) / integrals.mass;
  };
  const double spring =
      mean([&](double at, double) { return problem.system.restoring_force()(at); });
  const double balance = -0.1 * m.v1 - spring + problem.impulses.rate_times_moment(1) +
                         1.7 * transform::flux_into_left_wall(p, 2) / integrals.mass;
  EXPECT_NEAR(integrals.weak_residuals.colwise().sum().dot(v), balance, 1e-9);
  EXPECT_NEAR(m.y1, mean([](double at, double) { return at; }), 1e-11);
  EXPECT_NEAR(m.y2, mean([](double at, double) { return at * at; }), 1e-11);
  EXPECT_NEAR(m.y4, mean([](double at, double) { return std::pow(at, 4); }), 1e-11);
  EXPECT_NEAR(m.v1, mean([](double, double at) { return at; }), 1e-11);
  EXPECT_NEAR(m.v2, mean([](double, double at) { return at * at; }), 1e-11);
  EXPECT_NEAR(m.v4, mean([](double, double at) { return std::pow(at, 4); }), 1e-11);
}

TEST(WeakResiduals, VanishForTheExactSolutionWithTheGridsOrder) {
  const auto problem = tests::linear_problem();
  const exact::LinearDensity exact(problem);
  const auto integrator = make_coarse_integrator(problem);
  std::vector<double> worst;
  for (const int cells : {48, 72, 108}) {
    const auto y = tests::uniform_edges(0, 6, cells), v = tests::uniform_edges(-6, 6, 2 * cells);
    const auto integrals =
        integrator.integrate_density(transform::GridDensity{y, v, exact.joint_averages(y, v)});
    worst.push_back(integrals.weak_residuals.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst[2], 3e-8);
  for (const std::size_t k : {0U, 1U}) {
    const double order = std::log(worst[k] / worst[k + 1]) / std::log(1.5);
    EXPECT_GT(order, 6) << worst[k] << ' ' << worst[k + 1];
    EXPECT_LT(order, 10) << worst[k] << ' ' << worst[k + 1];
  }
}

TEST(WeakResiduals, RejectInvalidDensities) {
  const auto integrator = make_coarse_integrator(tests::make_problem());
  const auto refused = [&](const transform::Density& p) {
    EXPECT_THROW(integrator.integrate_density(p), InputError);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double constant : {0.0, -1.0, nan}) {
    refused(transform::SmoothDensity{[=](double, double) { return constant; }, 2, 2});
  }
  refused(transform::SmoothDensity{skew_bell, 0, 2});
  refused(transform::SmoothDensity{skew_bell, 2, nan});
  refused(transform::GridDensity{{0, 1, 2}, {-1, 0, 1}, {1, 1, 1}});
  refused(transform::GridDensity{{0, 1}, {-1, 1, 0}, {1, 1}});
  refused(transform::GridDensity{{0.5, 1}, {-1, 1}, {1}});
  refused(transform::GridDensity{{0}, {-1, 1}, {}});
  EXPECT_NEAR(integrator.integrate_density(transform::GridDensity{{0, 1}, {-1, 1}, {1}}).mass, 2,
              1e-14);
}

}  // namespace
}  // namespace fpkcheck::backward
