#include "mcs/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "exact/linear_moments.hpp"
#include "paper_cases.hpp"
#include "statistics.hpp"

namespace fpkcheck::mcs {
namespace {

using tests::expect_near;

EnsembleOptions ensemble(std::vector<double> times) {
  return {.start_displacement = 0.5, .start_velocity = 0.8, .times = std::move(times), .seed = 11};
}

TEST(Ensemble, HasTheExactMomentsOfTheLinearOscillatorOverTime) {
  for (const char* law : {"gaussian", "two_point"}) {
    const auto problem = tests::make_problem({.cubic = 0, .restitution = 1, .law = law});
    for (const auto& s : simulate_ensemble(problem, ensemble({0, 0.7, 1.9, 3, 8}))) {
      SCOPED_TRACE(s.time);
      const auto exact = exact::linear_moments_at(problem, {.var_z = 0.25, .var_v = 0.64}, s.time);
      expect_near(s.moments.y2, exact.zz, s.standard_errors.y2, "E[y^2]");
      expect_near(s.moments.v2, exact.vv, s.standard_errors.v2, "E[y'^2]");
    }
  }
}

TEST(Ensemble, StandardErrorsAreThoseOfTheGaussianStart) {
  const auto start = simulate_ensemble(tests::make_problem(), ensemble({0})).front();
  const double root = std::sqrt(1e5);
  // Var(z^2) = 2 sigma^4, Var(z'^2) = 2 sigma^4; Var|z| = (1 - 2/pi) sigma^2. The sampling error is
  // below 2 %.
  EXPECT_NEAR(start.standard_errors.y2 * root, std::sqrt(2.0) * 0.25, 0.02 * 0.35);
  EXPECT_NEAR(start.standard_errors.v2 * root, std::sqrt(2.0) * 0.64, 0.02 * 0.9);
  EXPECT_NEAR(start.standard_errors.y1 * root, std::sqrt(1 - 2 / M_PI) * 0.5, 0.02 * 0.3);
  expect_near(start.moments.y1, std::sqrt(2 / M_PI) * 0.5, start.standard_errors.y1, "E[y]");
}

TEST(Ensemble, MarginalsCoverTheFoldedGaussian) {
  EnsembleOptions options = ensemble({0});
  options.y_edges = {0, 0.1, 0.3, 0.6, 1.2};
  options.v_edges = {-1.6, -0.8, 0, 0.8, 1.6};
  const auto start = simulate_ensemble(tests::make_problem(), options).front();
  const auto cdf = [](double x, double deviation) { return std::erf(x / deviation / M_SQRT2) / 2; };
  for (std::size_t b = 0; b < start.y.size(); ++b) {
    const double exact =
        2 * (cdf(start.y.edges[b + 1], 0.5) - cdf(start.y.edges[b], 0.5)) / start.y.width(b);
    expect_near(start.y.density[b], exact, (start.y.upper[b] - start.y.lower[b]) / 3.92, "p(y)");
  }
  for (std::size_t b = 0; b < start.v.size(); ++b) {
    const double exact =
        (cdf(start.v.edges[b + 1], 0.8) - cdf(start.v.edges[b], 0.8)) / start.v.width(b);
    expect_near(start.v.density[b], exact, (start.v.upper[b] - start.v.lower[b]) / 3.92, "p(y')");
  }
}

TEST(Ensemble, DoesNotDependOnThreadsNorOnTheTimesBetween) {
  const auto problem = tests::make_problem({.restitution = 0.8});
  EnsembleOptions one = ensemble({2});
  one.trajectories = 1000;
  one.threads = 1;
  EnsembleOptions three = one;
  three.threads = 3;
  EnsembleOptions other_seed = one;
  other_seed.seed = 12;
  const double first = simulate_ensemble(problem, one).back().moments.y2;
  EXPECT_EQ(simulate_ensemble(problem, three).back().moments.y2, first);
  EXPECT_NE(simulate_ensemble(problem, other_seed).back().moments.y2, first);
  EnsembleOptions watched = one;
  watched.times = {0.5, 1, 2};  // shorter flights have other rounding errors
  EXPECT_NEAR(simulate_ensemble(problem, watched).back().moments.y2, first, 1e-7);
}

TEST(Ensemble, RefusesInvalidOptions) {
  const auto refused = [](auto change) {
    EnsembleOptions options = ensemble({1, 2});
    change(options);
    EXPECT_THROW(simulate_ensemble(tests::make_problem(), options), InputError);
  };
  refused([](auto& o) { o.times = {}; });
  refused([](auto& o) { o.times = {2, 1}; });
  refused([](auto& o) { o.times = {-1}; });
  refused([](auto& o) { o.start_velocity = -1; });
  refused([](auto& o) { o.start_displacement = NAN; });
  refused([](auto& o) { o.trajectories = 1; });
  refused([](auto& o) { o.threads = -1; });
  refused([](auto& o) { o.y_edges = {1, 0}; });
}

}  // namespace
}  // namespace fpkcheck::mcs
