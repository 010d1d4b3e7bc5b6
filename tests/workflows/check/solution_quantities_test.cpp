#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "solved_run.hpp"
#include "workflows/check/case_quantities.hpp"

namespace fpkcheck::check {
namespace {

using enum CheckedQuantityKind;
using tests::kinds;
using tests::moved_by;
using tests::scale;
using tests::solution;
using Kinds = std::vector<CheckedQuantityKind>;

TEST(SolutionClaims, StatusEquationMassAndBalanceAreFound) {
  const auto by = [](const auto& change) {
    return kinds(moved_by([&](results::Run& run) { change(solution(run, "fd-kf")); }));
  };
  EXPECT_EQ(by([](auto& fd) { fd.status = transform::Status::ill_posed; }), Kinds{status});
  EXPECT_EQ(by([](auto& fd) { fd.identity.equation = problem::DensityEquation::km4; }),
            Kinds{status});
  EXPECT_EQ(by([](auto& fd) { fd.identity.impact = problem::ImpactCondition::delta; }),
            Kinds{status});
  EXPECT_EQ(by([](auto& fd) { scale(fd.mass, 1e-6); }), Kinds{mass});
  EXPECT_EQ(by([](auto& fd) { fd.energy_residual -= 1e-6; }), Kinds{energy});
  EXPECT_EQ(by([](auto& fd) { fd.min_density -= 1e-13; }), Kinds{detail});
}

TEST(SolutionClaims, ReportsAMissingDensityOnce) {
  const auto moved = moved_by([](results::Run& run) {
    auto& lost = solution(run, "fd-kf");
    lost.status = transform::Status::not_converged;
    lost.had_density = false;
    lost.moments = {};
    lost.mass = lost.energy_residual = 0;
  });
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[1].name, "density");
}

TEST(SolutionClaims, ANumberThatIsNoLongerFiniteMoved) {
  const auto moved = moved_by([](results::Run& run) {
    solution(run, "fd-kf").moments.y2 = std::numeric_limits<double>::quiet_NaN();
  });
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_TRUE(std::isinf(moved[0].change));
}

TEST(SolutionClaims, StatedErrorsAreDetails) {
  const auto by = [](const auto& change) {
    return moved_by([&](results::Run& run) { change(solution(run, "fd-kf").error); });
  };
  EXPECT_EQ(kinds(by([](auto& error) { scale(error->y_l1, 0.5); })), Kinds{detail});
  EXPECT_EQ(kinds(by([](auto& error) { scale(error->ydot_l1, -0.2); })), Kinds{detail});
  for (const auto& of : transform::kMoments) {
    const auto moved = by([&](auto& error) { error->moments.*of.moment += 1e-7; });
    ASSERT_EQ(moved.size(), 1u) << of.symbol;
    EXPECT_EQ(moved[0].name, std::string("error of ") + of.symbol);
    // The error estimate of a moment is small, but has the rounding error of the moment.
    EXPECT_TRUE(by([&](auto& error) { error->moments.*of.moment += 5e-10; }).empty());
  }
  // A missing error estimate is reported if the baseline has it, not if the baseline lacks it.
  const tests::TwoRuns runs;
  results::Run without = runs.solved;
  solution(without, "fd-kf").error.reset();
  EXPECT_EQ(check::compare_runs(runs.files, without, {}).quantities_beyond_tolerance().size(), 1u);
  EXPECT_TRUE(check::compare_runs(without, runs.solved, {}).quantities_beyond_tolerance().empty());
}

TEST(SolutionClaims, AMomentOfASimulationIsJudgedByBothStandardErrors) {
  const auto by = [](double errors_of_one_run) {
    return moved_by([&](results::Run& run) {
      auto& mcs = solution(run, "mcs");
      mcs.moments.y2 += errors_of_one_run * mcs.standard_errors->moments.y2;
    });
  };
  EXPECT_EQ(by(5.5).size(), 0u);  // 4 standard errors of the difference are 5.66 of one run
  ASSERT_EQ(by(6).size(), 1u);
  EXPECT_EQ(by(6)[0].kind, simulated);
  EXPECT_NEAR(by(-6)[0].change, 6 / std::sqrt(2.0), 1e-6);
}

TEST(SolutionClaims, SimulatedMassAndBalanceChangeInStandardErrors) {
  const auto by = [](const auto& change) {
    return kinds(moved_by([&](results::Run& run) { change(solution(run, "mcs")); }));
  };
  EXPECT_EQ(by([](auto& mcs) { mcs.mass -= 1e-5; }), Kinds{});
  EXPECT_EQ(by([](auto& mcs) { mcs.mass -= 1e-2; }), Kinds{simulated});
  EXPECT_EQ(by([](auto& mcs) { mcs.energy_residual += 5e-4; }), Kinds{});
  EXPECT_EQ(by([](auto& mcs) { mcs.energy_residual += 2e-3; }), Kinds{simulated});
}

TEST(SolutionClaims, ToleranceOfErrorsGrowsWithTheirNumber) {
  results::Run run = tests::solved_run();
  const auto allowed = [&](const char* name) {
    for (const CheckedQuantity& quantity : solution_quantities(solution(run, "mcs"), {})) {
      if (quantity.name == name) return quantity.allowed;
    }
    return 0.0;
  };
  EXPECT_GT(allowed("standard error of E[y]"), 0.6);
  EXPECT_LT(allowed("standard error of E[y]"), 0.8);
  // Numbers of effective samples are proportional to 1 / error^2.
  const double error = allowed("standard error of E[y]");
  EXPECT_NEAR(allowed("effective_samples"), std::pow(1 + error, 2) - 1, 1e-9);
}

// The error estimate of a simulation is a difference of two simulations, which scatters freely.
TEST(SolutionClaims, TheErrorEstimateOfASimulationIsNotCompared) {
  results::Run run = tests::solved_run();
  transform::Solution& one = solution(run, "mcs");
  const auto count_of_error_estimate = [&] {
    one.error.reset();
    const std::size_t without = solution_quantities(one, {}).size();
    one.error = transform::ErrorEstimate{.y_l1 = 1e-3, .ydot_l1 = 1e-3};
    return solution_quantities(one, {}).size() - without;
  };
  EXPECT_EQ(count_of_error_estimate(), 0U);
  one.standard_errors.reset();
  EXPECT_GE(count_of_error_estimate(), 2 + std::size(transform::kMoments));
}

}  // namespace
}  // namespace fpkcheck::check
