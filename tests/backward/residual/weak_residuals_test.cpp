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

WeakResiduals residuals_of(const problem::Problem& problem) {
  return {problem,
          {numerics::QuinticBSplines(numerics::graded_knots(0, 6, 4, 14)),
           numerics::QuinticBSplines(numerics::graded_knots(-7, 7, 4, 28, 3))}};
}

/// A density without symmetry, whose value at the ends is 1e-11 of the peak.
double skew_bell(double y, double v) {
  return std::exp(-y * y - 0.8 * (v - 0.3) * (v - 0.3) - 0.4 * y * v) * (1 + 0.5 * y);
}
transform::SmoothDensity skew_density() { return {skew_bell, 6, 6.5}; }

double function(const numerics::QuinticBSplines& splines, int i, double x, bool slope = false) {
  const auto at = splines.values_and_slopes(x);
  if (i < at.first || i > at.first + numerics::QuinticBSplines::kDegree) return 0;
  return slope ? at.slope[static_cast<std::size_t>(i - at.first)]
               : at.value[static_cast<std::size_t>(i - at.first)];
}

/// The integral over [a, b], divided at the breaks of splines times `factor`.
double integral(const std::function<double(double)>& f, double a, double b,
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
  for (const auto& atom : law.atoms()) sum += atom.probability * f(atom.amplitude);
  const auto pieces = law.density_breakpoints();
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    sum += numerics::integrate_by_composite_gauss([&](double z) { return law.density(z) * f(z); },
                                                  pieces[k], pieces[k + 1], 12);
  }
  return sum;
}

/// rho_ij by its definition, for the unnormalised density above. The jump operator acts on p
/// instead of B_j: int p K B dv = int B(w) E[p(w - Y)] dw.
double by_definition(const problem::Problem& problem, const WeakResiduals& splines, int i, int j) {
  const numerics::QuinticBSplines &in_y = splines.y(), &in_v = splines.v();
  const auto& system = problem.system;
  const auto inside = [](double y, double v) { return std::abs(v) < 6.5 ? skew_bell(y, v) : 0; };
  const auto over_v = [&](double y) {
    const double a = function(in_y, i, y), slope = function(in_y, i, y, true);
    if (a == 0 && slope == 0) return 0.0;
    return integral(
        [&](double v) {
          const double b = function(in_v, j, v), of_b = function(in_v, j, v, true);
          const double p = inside(y, v);
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
        -7, 7, in_v.breaks());
  };
  const double r = system.restitution();
  const double local = integral(over_v, 0, 6, in_y.breaks());
  const double in = integral([&](double u) { return u * inside(0, -u) * function(in_v, j, -u); }, 0,
                             7, in_v.breaks(), -1);
  const double out =
      integral([&](double u) { return u * inside(0, -u) * function(in_v, j, r * u); }, 0, 7,
               in_v.breaks(), 1 / r);
  return local + function(in_y, i, 0) * (out - in);
}

TEST(WeakResiduals, MatchTheirDefinitionForEveryLaw) {
  for (const char* law : tests::kSymmetricLaws) {
    const auto problem = tests::make_problem(
        {.damping = 0.3, .restitution = 0.7, .rate = 1.7, .mean = 0.1, .law = law});
    const auto residuals = residuals_of(problem);
    const auto weak = residuals(skew_density());
    // Indices of functions at the wall (incoming, outgoing and at v = 0), inside, and of the last
    // function of y.
    for (const auto& [i, j] : {std::pair{0, 13}, {0, 19}, {0, 16}, {4, 12}, {7, 20}, {1, 18}}) {
      EXPECT_NEAR(weak.mass * weak.residuals(i, j), by_definition(problem, residuals, i, j), 1e-8)
          << law << ' ' << i << ' ' << j;
      EXPECT_GT(std::abs(weak.residuals(i, j)), 1e-5) << i << ' ' << j;
    }
  }
}

TEST(WeakResiduals, OfCellAveragesAreThoseOfTheFunction) {
  // Different cell widths for v < 0 and v > 0.
  const auto residuals = residuals_of(tests::make_problem({.restitution = 0.7, .mean = 0.1}));
  auto v = tests::uniform_edges(-6.5, 0, 100);
  for (const double edge : tests::uniform_edges(0, 6.5, 80)) {
    if (edge > 0) v.push_back(edge);
  }
  const auto grid =
      transform::average_over_cells(skew_density(), tests::uniform_edges(0, 6, 90), v);
  const auto of_grid = residuals(grid), of_function = residuals(skew_density());
  EXPECT_LT((of_grid.residuals - of_function.residuals).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((of_grid.means - of_function.means).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(of_grid.mass, transform::mass(grid), 1e-13);
}

TEST(WeakResiduals, SumToZeroAndMeansToOne) {
  for (const char* law : tests::kSymmetricLaws) {
    const auto problem = tests::make_problem({.restitution = 0.7, .mean = 0.1, .law = law});
    const auto weak = residuals_of(problem)(skew_density());
    EXPECT_NEAR(weak.residuals.sum(), 0, 1e-14) << law;
    EXPECT_GT(weak.residuals.cwiseAbs().sum(), 0.1);
    EXPECT_NEAR(weak.means.sum(), 1, 1e-14);
  }
}

TEST(WeakResiduals, OfPowersAreTheBalances) {
  // L y = v and L v = -c v - g(y) + lambda E[Y]; impacts change v by (1 + r) u.
  const auto problem = tests::make_problem({.restitution = 0.7, .mean = 0.1});
  const auto residuals = residuals_of(problem);
  const auto p = skew_density();
  const auto weak = residuals(p);
  const auto of_y = residuals.y().coefficients_of_monomial(1),
             of_v = residuals.v().coefficients_of_monomial(1);
  const Eigen::Map<const Eigen::VectorXd> y(of_y.data(), std::ssize(of_y)),
      v(of_v.data(), std::ssize(of_v));
  const auto& m = weak.moments;
  EXPECT_NEAR(y.dot(weak.residuals.rowwise().sum()), m.v1, 1e-9);
  const auto mean = [&](const std::function<double(double, double)>& g) {
    return transform::expectation(p, g) / weak.mass;
  };
  const double spring =
      mean([&](double at, double) { return problem.system.restoring_force()(at); });
  const double balance = -0.1 * m.v1 - spring + problem.impulses.rate_times_moment(1) +
                         1.7 * transform::impact_flux(p, 2) / weak.mass;
  EXPECT_NEAR(weak.residuals.colwise().sum().dot(v), balance, 1e-9);
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
  const auto residuals = residuals_of(problem);
  std::vector<double> worst;
  for (const int cells : {48, 72, 108}) {
    const auto y = tests::uniform_edges(0, 6, cells), v = tests::uniform_edges(-6, 6, 2 * cells);
    const auto weak = residuals(transform::GridDensity{y, v, exact.joint_averages(y, v)});
    worst.push_back(weak.residuals.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst[2], 3e-8);
  for (const std::size_t k : {0U, 1U}) {
    const double order = std::log(worst[k] / worst[k + 1]) / std::log(1.5);
    EXPECT_GT(order, 6) << worst[k] << ' ' << worst[k + 1];
    EXPECT_LT(order, 10) << worst[k] << ' ' << worst[k + 1];
  }
}

TEST(WeakResiduals, RejectInvalidDensities) {
  const auto residuals = residuals_of(tests::make_problem());
  const auto refused = [&](const transform::Density& p) { EXPECT_THROW(residuals(p), InputError); };
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
  EXPECT_NEAR(residuals(transform::GridDensity{{0, 1}, {-1, 1}, {1}}).mass, 2, 1e-14);
}

}  // namespace
}  // namespace fpkcheck::backward
