#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "exact/closed_forms.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"

namespace fpkcheck::mcs {
namespace {

using tests::expect_within_four_errors;

TEST(StationaryMoments, OfTheLinearOscillatorAreTheExactOnes) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    SCOPED_TRACE(law);
    const auto problem = tests::make_problem({.cubic = 0, .restitution = 1, .law = law});
    const auto [solution, summary] = tests::simulate(problem, 1e6);
    const auto& m = solution.moments;
    const auto& e = solution.standard_errors->moments;
    const double y2 = exact::linear_cumulant(problem, 2, 0);
    const double v2 = exact::linear_cumulant(problem, 0, 2);
    expect_within_four_errors(m.y2, y2, e.y2, "E[y^2]");
    expect_within_four_errors(m.v2, v2, e.v2, "E[v^2]");
    expect_within_four_errors(m.y4, exact::linear_cumulant(problem, 4, 0) + 3 * y2 * y2, e.y4,
                              "E[y^4]");
    expect_within_four_errors(m.v4, exact::linear_cumulant(problem, 0, 4) + 3 * v2 * v2, e.v4,
                              "E[v^4]");
    expect_within_four_errors(m.v1, 0, e.v1, "E[v]");
    // The errors suffice to distinguish impulses from white noise (0.75) by the fourth moments.
    EXPECT_LT(e.y4, 0.005);
    EXPECT_LT(e.v4, 0.005);
  }
}

TEST(StationaryMoments, OfTheElasticDuffingOscillatorAreThoseOfTheSpectralComputation) {
  struct Row {
    double intensity, cubic, rate, y2, y4, v4, v4_error;
  };
  for (const Row& row :
       {Row{.1, .1, 1, .44181, .58190, .8078, 5e-5}, Row{.1, 1, 1, .28632, .21368, .8107, 5e-5},
        Row{1, 1, 1, 1.2564, 3.743, 81.3, .1}, Row{.1, .1, 10, .44410, .55904, .7558, 5e-5}}) {
    const auto problem = tests::make_problem(
        {.cubic = row.cubic, .restitution = 1, .rate = row.rate, .intensity = row.intensity});
    SCOPED_TRACE(row.v4);
    const auto [solution, summary] = tests::simulate(problem);
    const auto& m = solution.moments;
    const auto& e = solution.standard_errors->moments;
    expect_within_four_errors(m.y2, row.y2, e.y2, "E[y^2]", row.intensity == 1 ? 5e-5 : 5e-6);
    expect_within_four_errors(m.y4, row.y4, e.y4, "E[y^4]", row.intensity == 1 ? 5e-4 : 5e-6);
    expect_within_four_errors(m.v4, row.v4, e.v4, "E[v^4]", row.v4_error);
    expect_within_four_errors(m.v2, exact::mean_square_velocity(problem), e.v2, "E[v^2]");
  }
}

TEST(StationaryMoments, WithLossesAtTheImpactKeepTheBalanceOfPower) {
  for (const double r : {0.98, 0.7, 0.3, 0.05}) {
    SCOPED_TRACE(r);
    const auto [solution, summary] = tests::simulate(tests::make_problem({.restitution = r}), 3e5);
    expect_within_four_errors(solution.energy_residual, 0,
                              solution.standard_errors->energy_residual, "residual");
    // The weights account for the work of the impulses: the balance is far more precise than the
    // moments.
    EXPECT_LT(solution.standard_errors->energy_residual, 1e-3);
  }
}

TEST(StationaryMoments, WithLossesAndAMeanKeepTheBalancesOfVirialAndMomentum) {
  for (const double r : {0.98, 0.6, 0.1}) {
    for (const double mean : {0.0, 0.2, -0.2}) {
      SCOPED_TRACE(fmt::format("r = {}, mean {}", r, mean));
      const auto summary =
          tests::simulate(tests::make_problem({.restitution = r, .mean = mean}), 2e5).summary;
      const auto& [virial, momentum] = summary.balances;
      const auto& [virial_error, momentum_error] = summary.balance_errors;
      expect_within_four_errors(*virial, 0, *virial_error, "virial");
      expect_within_four_errors(*momentum, 0, *momentum_error, "momentum");
      // The errors suffice to distinguish r from 1 - r, and the sign of the mean.
      EXPECT_LT(*virial_error, 0.01);
      EXPECT_LT(*momentum_error, 0.01);
    }
  }
}

// The weights would hide a wrong rate or law of the impulses, so the test uses the excess power.
TEST(StationaryMoments, AreThoseOfImpulsesThatBringThePowerOfTheirLaw) {
  for (const auto& [law, mean] :
       {std::pair{"gaussian", 0.0}, std::pair{"gaussian", 0.2}, std::pair{"gaussian", -0.2},
        std::pair{"laplace", 0.2}, std::pair{"two_point", 0.2}, std::pair{"uniform", -0.2}}) {
    SCOPED_TRACE(fmt::format("{} about {}", law, mean));
    const auto summary =
        tests::simulate(tests::make_problem({.rate = 2, .mean = mean, .law = law})).summary;
    expect_within_four_errors(summary.excess_power, 0, summary.excess_power_error, "excess power");
    EXPECT_LT(summary.excess_power_error, 0.01);
    expect_within_four_errors(static_cast<double>(summary.impulses), 2 * summary.time,
                              std::sqrt(2 * summary.time), "number of impulses");
  }
}

TEST(StationaryMoments, UnderImpulsesWithAMeanKeepTheBalanceOfPower) {
  for (const double mean : {0.2, -0.2}) {
    SCOPED_TRACE(mean);
    const auto lossy = tests::make_problem({.restitution = 0.7, .mean = mean});
    const auto [solution, summary] = tests::simulate(lossy, 3e5);
    expect_within_four_errors(solution.energy_residual, 0,
                              solution.standard_errors->energy_residual, "residual");
    expect_within_four_errors(solution.moments.v1, 0, solution.standard_errors->moments.v1, "E[v]");
    // r = 1: with E[v] = 0 the input is lambda E[Y^2]/2 for any mean.
    const auto elastic = tests::make_problem({.restitution = 1, .mean = mean});
    const auto undisturbed = tests::simulate(elastic, 3e5);
    expect_within_four_errors(undisturbed.solution.moments.v2, exact::mean_square_velocity(elastic),
                              undisturbed.solution.standard_errors->moments.v2, "E[v^2]");
  }
  // A mean away from the wall increases E[y].
  EXPECT_GT(tests::simulate(tests::make_problem({.mean = 0.2}), 1e4).solution.moments.y1,
            tests::simulate(tests::make_problem({.mean = -0.2}), 1e4).solution.moments.y1 + 0.1);
}

TEST(StationaryMoments, OfCases2And3AreOneProblemInTwoScales) {
  // z -> a z maps (mu, I) to (mu/a^2, a^2 I).
  const auto second = tests::simulate(tests::paper_case(2), 3e5, 1);
  const auto third = tests::simulate(tests::paper_case(3), 3e5, 2);
  const auto& [m2, m3] = std::pair{second.solution.moments, third.solution.moments};
  const auto& e2 = second.solution.standard_errors->moments;
  const auto& e3 = third.solution.standard_errors->moments;
  expect_within_four_errors(10 * m3.y2, m2.y2, std::hypot(10 * e3.y2, e2.y2), "E[y^2]");
  expect_within_four_errors(100 * m3.v4, m2.v4, std::hypot(100 * e3.v4, e2.v4), "E[v^4]");
}

}  // namespace
}  // namespace fpkcheck::mcs
