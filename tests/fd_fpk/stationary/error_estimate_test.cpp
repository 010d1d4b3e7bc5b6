#include "fd_fpk/stationary/error_estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>

#include "base/input_error.hpp"
#include "distances.hpp"
#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::StateVariable;
using transform::Status;

const base::Deadline kNoDeadline(HUGE_VAL);

// A density that is uniform except for a wave in y of the given amplitude.
transform::Solution wave(double amplitude) {
  transform::Solution solution;
  transform::GridDensity density{{0, 1, 2, 3, 4}, {-1, 0, 1}, {}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 2; ++j) {
      density.averages.push_back(0.125 + amplitude * (i % 2 == 0 ? 1 : -1));
    }
  }
  solution.density = density;
  solution.moments = {.y2 = 1 + amplitude, .v2 = 1};
  return solution;
}

FiniteVolumeResult on_grid(double amplitude, double impact_rate = 0) {
  FiniteVolumeResult result{.solution = wave(amplitude), .summary = {}};
  result.summary.impact_rate = impact_rate;
  return result;
}

TEST(ErrorEstimate, IsTheRemainderOfAGeometricSeries) {
  // Errors 16 e, 4 e, e: order 4 at the ratio sqrt 2.
  const double e = 0.001;
  const auto error =
      estimate_error_from_three_grids(on_grid(16 * e), on_grid(4 * e), on_grid(e), 5);
  EXPECT_NEAR(error.observed_order, 4, 1e-9);
  EXPECT_NEAR(error.y_l1, 8 * e, 1e-12);  // |amplitude| over an area of 8
  EXPECT_NEAR(error.moments.y2, e, 1e-12);
  EXPECT_NEAR(error.extrapolated.y2, 1, 1e-12);
  EXPECT_NEAR(error.ydot_l1, 0, 1e-12);
}

TEST(ErrorEstimate, DoesNotMistakeChanceAgreementForAccuracy) {
  // The last two levels agree by chance: the preceding difference and the order of the scheme bound
  // the error from below.
  const auto error =
      estimate_error_from_three_grids(on_grid(0.016), on_grid(0.001), on_grid(0.001), 5);
  EXPECT_GT(error.moments.y2, 0.5 * 0.015 / std::pow(2, 2.5) / std::pow(2, 2.5));
  // Constant differences do not indicate convergence.
  const auto stalled =
      estimate_error_from_three_grids(on_grid(0.001), on_grid(0.003), on_grid(0.001), 5);
  EXPECT_GT(stalled.moments.y2, 0.002);
}

// The coarsest grid does not resolve the density. An observed order of 14 is impossible for a
// scheme of order 5, and must not reduce the estimate to a fifth of the last difference.
TEST(ErrorEstimate, IgnoresAnImplausibleObservedOrder) {
  const auto error =
      estimate_error_from_three_grids(on_grid(0.129), on_grid(0.002), on_grid(0.001), 5);
  EXPECT_GT(error.observed_order, 13);
  EXPECT_GE(error.y_l1, 8 * 0.001 / (transform::kRefinementRatio - 1) * (1 - 1e-12));
  EXPECT_GE(error.moments.y2, 0.001 / (transform::kRefinementRatio - 1) * (1 - 1e-12));
  EXPECT_FALSE(error.has_richardson_limit);
  // Cancellation of errors may raise the observed order slightly above that of the scheme.
  const auto cancelling = estimate_error_from_three_grids(
      on_grid(0.001 * std::pow(2, 6.5)), on_grid(0.001 * std::pow(2, 3.25)), on_grid(0.001), 5);
  EXPECT_NEAR(cancelling.observed_order, 6.5, 0.5);
  EXPECT_TRUE(cancelling.has_richardson_limit);
}

// A rate whose differences decrease with the order 1.4 of a singularity, beside marginals of order
// 4.
TEST(ErrorEstimate, OfTheImpactRateUsesItsOwnLowerOrder) {
  const double e = 0.001, q = std::pow(2, 0.7);
  const auto error = estimate_error_from_three_grids(
      on_grid(16 * e, 1 + e * q * q), on_grid(4 * e, 1 + e * q), on_grid(e, 1 + e), 5);
  EXPECT_NEAR(error.impact_rate, e, 1e-9);
  EXPECT_NEAR(error.moments.y2, e, 1e-12);
}

TEST(ErrorEstimate, HasTheSizeOfTheTrueError) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  const exact::LinearDensity exact(p);
  for (const double refinement : {0.8, 1.2}) {
    const auto [solution, summary] = solve_stationary_density(
        p, {.stepper = StationarySolver::direct, .refinement = refinement, .error_estimate = true});
    ASSERT_TRUE(summary.error.has_value());
    const auto [y, v] = tests::distances(
        solution, [&](const auto& edges) { return exact.displacement_averages(edges); },
        [&](const auto& edges) { return exact.velocity_averages(edges); });
    EXPECT_GT(summary.error->y_l1, 0.5 * y);
    EXPECT_LT(summary.error->y_l1, 4 * y);
    EXPECT_GT(summary.error->ydot_l1, 0.5 * v);
    EXPECT_LT(summary.error->ydot_l1, 4 * v);
    const double y2 = exact::linear_cumulant(p, 2, 0);
    EXPECT_LT(std::abs(solution.moments.y2 - y2), 2 * summary.error->moments.y2);
  }
}

TEST(ErrorEstimate, AToleranceSelectsASufficientGridAndNotAMuchFinerOne) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  const exact::LinearDensity exact(p);
  int cells_before = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const auto [solution, summary] =
        solve_stationary_density(p, {.stepper = StationarySolver::direct, .tolerance = tolerance});
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    const auto [y, v] = tests::distances(
        solution, [&](const auto& edges) { return exact.displacement_averages(edges); },
        [&](const auto& edges) { return exact.velocity_averages(edges); });
    EXPECT_LT(y, tolerance);
    EXPECT_LT(v, tolerance);
    if (tolerance < 1e-4) {
      EXPECT_GT(std::max(y, v), tolerance / 50);
    }
    EXPECT_GE(summary.nx * summary.nv, cells_before);
    cells_before = summary.nx * summary.nv;
  }
}

// Rare impulses or impulses with long tails move the oscillator out of its box. Three grids in one
// box do not show this truncation: the stated error of E[y'^4] was 1e-5, the true error 6e-4.
TEST(ErrorEstimate, IncludesTheTruncationOfMomentsByTheBox) {
  for (const tests::Parameters& parameters :
       {tests::Parameters{.restitution = 0.9, .rate = 0.3}, tests::Parameters{.law = "laplace"}}) {
    const auto p = tests::make_problem(parameters);
    FiniteVolumeOptions options{.stepper = StationarySolver::direct,
                                .transport = TransportScheme::upwind};
    const auto solution = solve_stationary_density(p, options).solution;
    ASSERT_TRUE(solution.error) << solution.reason;
    options.wall_density = 1e-10;
    options.error_estimate = false;
    const auto wide = solve_stationary_density(p, options).solution;
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      EXPECT_LT(std::abs(wide.moments.*moment - solution.moments.*moment),
                1.1 * solution.error->moments.*moment)
          << symbol;
    }
    // Truncation dominates the error, and the estimate is not much too large.
    EXPECT_LT(solution.error->moments.v4, 2 * (wide.moments.v4 - solution.moments.v4));
  }
}

TEST(ErrorEstimate, AToleranceWidensTheBoxForTheSecondMoments) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1, .rate = 0.3, .law = "laplace"});
  const double tolerance = 1e-4;
  const auto [solution, summary] = solve_stationary_density(
      p, {.stepper = StationarySolver::direct, .max_seconds = 600, .tolerance = tolerance});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  const double y2 = exact::linear_cumulant(p, 2, 0), v2 = exact::linear_cumulant(p, 0, 2);
  EXPECT_LT(std::abs(solution.moments.y2 - y2), tolerance * y2);
  EXPECT_LT(std::abs(solution.moments.v2 - v2), tolerance * v2);
}

// A solver whose error decreases with the given order on uniform grids and with order 5 on graded
// grids. It fails on cells narrower than half of the automatic width.
SolveOnOneGrid solver_of_order(double uniform_order, std::vector<FiniteVolumeOptions>& requests) {
  const auto mutex = std::make_shared<std::mutex>();
  return [=, &requests](const FiniteVolumeOptions& options) {
    {
      const std::lock_guard lock(*mutex);
      requests.push_back(options);
    }
    FiniteVolumeResult result;
    result.summary.origin_refinement = options.origin_refinement.value_or(1);
    if (options.refinement > 2.1) {
      result.solution.status = Status::failed;
      result.solution.reason = "too many cells";
      return result;
    }
    const double order = result.summary.origin_refinement > 1 ? 5 : uniform_order;
    result.solution = wave(0.01 * std::pow(options.refinement, -order));
    result.solution.status = Status::ok;
    return result;
  };
}

TEST(ErrorEstimate, SlowConvergenceTurnsOnTheGrading) {
  for (const double order : {1.5, 4.5}) {
    std::vector<FiniteVolumeOptions> requests;
    const auto result = refine_grid_to_tolerance(
        solver_of_order(order, requests), {.stepper = StationarySolver::direct, .tolerance = 5e-3},
        kNoDeadline);
    EXPECT_EQ(result.solution.status, Status::ok) << result.solution.reason;
    EXPECT_EQ(result.summary.origin_refinement > 1, order < 2) << order;
    EXPECT_LE(result.summary.error->y_l1, 5e-3);
    EXPECT_LT(requests.back().wall_density, 1e-4);
  }
}

TEST(ErrorEstimate, ExtrapolationGivesTheLimitOfAManufacturedSequence) {
  // Waves of amplitude 0.01 F^-4 on grids F times finer converge to the uniform density.
  const std::vector<double> edges{0, 1, 2, 3, 4};
  std::vector<FiniteVolumeOptions> requests;
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(3e-3)}) {
    for (const auto stepper : {StationarySolver::direct, StationarySolver::cvode}) {
      const FiniteVolumeOptions options{
          .stepper = stepper, .error_estimate = !tolerance, .tolerance = tolerance};
      const auto solve_one = solver_of_order(4, requests);
      const auto solution = tolerance
                                ? refine_grid_to_tolerance(solve_one, options, kNoDeadline).solution
                                : solve_with_error_estimate(solve_one, options).solution;
      const auto fine = transform::marginal(solution, StateVariable::y, edges);
      const auto limit = transform::richardson_limit_marginal(solution, StateVariable::y, edges);
      for (std::size_t k = 0; k < limit.size(); ++k) {
        EXPECT_GT(std::abs(fine.density[k] - 0.25), 1e-5);
        EXPECT_NEAR(limit.density[k], 0.25, 1e-12);
      }
    }
  }
  EXPECT_THROW(transform::richardson_limit_marginal(wave(0.1), StateVariable::y, edges),
               std::logic_error);
}

// Slowly decreasing differences determine the size of the error, but no limit.
TEST(ErrorEstimate, SlowConvergenceHasNoLimit) {
  for (const double order : {1.3, 1.7}) {
    std::vector<FiniteVolumeOptions> requests;
    const auto solution =
        solve_with_error_estimate(solver_of_order(order, requests),
                                  {.stepper = StationarySolver::direct, .error_estimate = true})
            .solution;
    EXPECT_EQ(solution.extrapolation.has_value(), order > transform::kMinOrderForLimit) << order;
  }
}

TEST(ErrorEstimate, AnEstimateAboveTheRequestedAccuracyIsInaccurate) {
  for (const double amplitude : {0.0008, 0.004}) {  // L1 of p(y): 8 times the amplitude
    const auto solve_one = [&](const FiniteVolumeOptions& options) {
      FiniteVolumeResult result;
      result.solution = wave(amplitude * std::pow(options.refinement, -4));
      result.solution.status = Status::ok;
      return result;
    };
    const auto solution = solve_with_error_estimate(solve_one, {.stepper = StationarySolver::direct,
                                                                .error_estimate = true})
                              .solution;
    EXPECT_EQ(solution.status, amplitude < 0.001 ? Status::ok : Status::inaccurate);
  }
}

// Coarser grids that are solved beside the finest grid are used only if they have its box and the
// widths of its cells times q and q^2.
TEST(ErrorEstimate, DoesNotDependOnWhetherTheBoxIsKnown) {
  for (const bool moves_box : {false, true}) {
    for (const bool refines : {false, true}) {
      std::atomic<int> solutions = 0;
      const auto solve_one = [&](const FiniteVolumeOptions& options) {
        ++solutions;
        FiniteVolumeResult result;
        const bool is_finest = options.refine_unresolved;
        const double refinement = options.refinement * (is_finest && refines ? 1.5 : 1);
        const double box = options.x1_max.value_or(is_finest && moves_box ? 5 : 4);
        result.solution = wave(1e-3 * box * std::pow(refinement, -4));
        for (double& edge : std::get<transform::GridDensity>(*result.solution.density).y_edges) {
          edge *= box / 4;
        }
        result.solution.status = Status::ok;
        result.summary.refinement = refinement;
        result.summary.x1_max = box;
        result.summary.x2_max = 1;
        return result;
      };
      const FiniteVolumeOptions options{.stepper = StationarySolver::direct,
                                        .error_estimate = true};
      const FiniteVolumeResult expected = solve_with_error_estimate(solve_one, options);
      EXPECT_EQ(solutions, 3);
      const FiniteVolumeResult result =
          solve_with_error_estimate(solve_one, options, PhasePlaneBox{.x1_max = 4, .x2_max = 1});
      EXPECT_EQ(solutions, moves_box || refines ? 8 : 6);
      EXPECT_EQ(result.summary.error->y_l1, expected.summary.error->y_l1);
      EXPECT_EQ(result.summary.error->moments.y2, expected.summary.error->moments.y2);
    }
  }
}

// The choice of the grid depends on the number of cells, not on measured times: the solutions of
// this test take no time.
TEST(ErrorEstimate, FinerGridsAreChosenByTheirNumberOfCells) {
  constexpr double kSeconds = 10;
  const auto levels_from = [&](int cells, TransportScheme transport) {
    std::mutex mutex;
    std::vector<double> refinements;
    const auto solve_one = [&](const FiniteVolumeOptions& options) {
      {
        const std::lock_guard lock(mutex);
        refinements.push_back(options.refinement);
      }
      FiniteVolumeResult result;
      result.summary.refinement = options.refinement;
      result.summary.transport = transport;
      result.summary.nx = static_cast<int>(cells * options.refinement * options.refinement);
      result.summary.nv = 1;
      result.solution = wave(1.8e-4 * std::pow(options.refinement, -4));
      result.solution.status = Status::ok;
      return result;
    };
    const auto result = refine_grid_until_deadline(
        solve_one, {.order = 5}, base::Deadline(kSeconds), GridRefinementGoal::accurate);
    EXPECT_EQ(result.summary.refinement, *std::ranges::max_element(refinements));
    return std::lround(2 * std::log2(result.summary.refinement));
  };
  EXPECT_EQ(levels_from(3000, TransportScheme::upwind), 2);
  EXPECT_EQ(levels_from(5000, TransportScheme::upwind), 0);
  EXPECT_EQ(levels_from(5000, TransportScheme::characteristics), 2);
}

// The target accuracy is not attainable in time. Only densities that a finer grid might make
// nonnegative are refined further.
TEST(ErrorEstimate, ADensityWithANegativeLimitIsNotRefinedForTheStatus) {
  const auto refinement_of = [](problem::ImpactCondition impact, double min_density) {
    const auto solve_one = [min_density](const FiniteVolumeOptions& options) {
      constexpr double kMaxRefinement = 3;
      FiniteVolumeResult result;
      if (options.refinement > kMaxRefinement) return result;
      result.summary.refinement = options.refinement;
      result.summary.nx = static_cast<int>(5000 * options.refinement * options.refinement);
      result.summary.nv = 1;
      result.solution = wave(1.8e-4 * std::pow(options.refinement, -4));
      result.solution.min_density = min_density;
      result.solution.status = Status::inadmissible;
      return result;
    };
    return refine_grid_until_deadline(solve_one, {.impact = impact, .order = 5}, base::Deadline(10),
                                      GridRefinementGoal::accurate)
        .summary.refinement;
  };
  EXPECT_EQ(refinement_of(problem::ImpactCondition::delta, -2e-3), 1);
  EXPECT_GT(refinement_of(problem::ImpactCondition::delta, -5e-4), 1);
  EXPECT_GT(refinement_of(problem::ImpactCondition::map, -2e-3), 1);
}

// The first graded grid gives no density: the result of the uniform grids is returned.
TEST(ErrorEstimate, ResultsBeforeTheGradingAreKept) {
  const auto solve_one = [](const FiniteVolumeOptions& options) {
    FiniteVolumeResult result;
    result.summary.origin_refinement = options.origin_refinement.value_or(1);
    if (result.summary.origin_refinement > 1) {
      result.solution.status = Status::failed;
      result.solution.reason = "too many cells";
    } else {
      result.solution = wave(0.01 / options.refinement);
      result.solution.status = Status::ok;
    }
    return result;
  };
  const auto result = refine_grid_to_tolerance(
      solve_one, {.stepper = StationarySolver::direct, .tolerance = 1e-4}, kNoDeadline);
  EXPECT_EQ(result.solution.status, Status::not_converged);
  EXPECT_TRUE(result.solution.density.has_value());
  EXPECT_NE(result.solution.reason.find("error estimate 8"), std::string::npos)
      << result.solution.reason;
}

TEST(ErrorEstimate, TheDeadlineEndsTheSearchForATolerance) {
  std::vector<FiniteVolumeOptions> requests;
  const auto result = refine_grid_to_tolerance(
      solver_of_order(4, requests), {.stepper = StationarySolver::direct, .tolerance = 1e-9},
      base::Deadline(0));
  EXPECT_EQ(requests.size(), 1u);  // one solution at any time limit
  EXPECT_EQ(result.solution.status, Status::not_converged);
  EXPECT_TRUE(result.solution.density.has_value());
  EXPECT_NE(result.solution.reason.find("max_seconds"), std::string::npos)
      << result.solution.reason;
}

TEST(ErrorEstimate, SteppingToATolerancePassesTheEstimateOn) {
  const auto [solution, summary] =
      solve_stationary_density(tests::paper_case(1), {.tolerance = 1e-4});
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_GT(summary.steps, 1);
  ASSERT_TRUE(summary.error.has_value());
  EXPECT_LT(summary.error->ydot_l1, 1e-4);
}

TEST(ErrorEstimate, AnUnattainableToleranceIsNotConvergedAndStatesItsEstimate) {
  std::vector<FiniteVolumeOptions> requests;
  const auto [solution, summary] = refine_grid_to_tolerance(
      solver_of_order(5, requests), {.stepper = StationarySolver::direct, .tolerance = 1e-12},
      kNoDeadline);
  EXPECT_EQ(solution.status, Status::not_converged);
  EXPECT_NE(solution.reason.find("requested 1.0e-12"), std::string::npos) << solution.reason;
  EXPECT_NE(solution.reason.find("too many cells"), std::string::npos) << solution.reason;
  ASSERT_TRUE(summary.error.has_value());
}

TEST(ErrorEstimate, AToleranceExcludesCellNumbers) {
  EXPECT_THROW(solve_stationary_density(tests::paper_case(1), {.nx = 40, .tolerance = 1e-4}),
               InputError);
  EXPECT_THROW(solve_stationary_density(tests::paper_case(1), {.tolerance = 0.0}), InputError);
}

// Grids with the same cells have equal solutions, whose difference would not measure the error.
TEST(ErrorEstimate, IsAbsentForLevelsWithTheSameCells) {
  const auto p = tests::paper_case(1);
  const auto coarsest =
      solve_stationary_density(p, {.stepper = StationarySolver::direct, .refinement = 0.01});
  EXPECT_NE(coarsest.solution.status, transform::Status::ok);
  const auto coarse =
      solve_stationary_density(p, {.stepper = StationarySolver::direct, .refinement = 0.3});
  ASSERT_TRUE(coarse.solution.error);
  const auto fine = solve_stationary_density(p, {.stepper = StationarySolver::direct});
  EXPECT_GT(coarse.solution.error->moments.y2,
            0.5 * std::abs(coarse.solution.moments.y2 - fine.solution.moments.y2));
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
