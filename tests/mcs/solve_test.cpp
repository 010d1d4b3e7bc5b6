#include "mcs/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::StateVariable;

const transform::GridDensity& joint_density(const SimulationResult& result) {
  return std::get<transform::GridDensity>(*result.solution.density);
}

const transform::Marginal& estimated_marginal(const SimulationResult& result,
                                              StateVariable variable) {
  for (const auto& [which, marginal] : result.solution.estimated_marginals) {
    if (which == variable) return marginal;
  }
  throw std::logic_error("no such marginal");
}

double integral_of_marginal(const transform::Marginal& marginal) {
  double sum = 0;
  for (std::size_t b = 0; b < marginal.size(); ++b)
    sum += marginal.density[b] * marginal.bin_width(b);
  return sum;
}

TEST(Solve, GivesTheSameResultForAnyNumberOfThreads) {
  SimulationOptions options;
  options.time = 2e4;
  options.streams = 10;
  options.seed = 0x123456789abcdefull;
  options.threads = 1;
  const SimulationResult one = simulate_stationary_density(tests::paper_case(1), options);
  for (const int threads : {2, 7}) {
    options.threads = threads;
    const SimulationResult many = simulate_stationary_density(tests::paper_case(1), options);
    EXPECT_EQ(joint_density(one).averages, joint_density(many).averages);
    EXPECT_EQ(one.solution.moments.y4, many.solution.moments.y4);
    EXPECT_EQ(one.solution.energy_residual, many.solution.energy_residual);
    EXPECT_EQ(one.solution.standard_errors->moments.v2, many.solution.standard_errors->moments.v2);
    EXPECT_EQ(many.summary.threads, threads);
  }
}

TEST(Solve, DifferentSeedsGiveDifferentRunsInEitherHalfOfTheSeed) {
  const auto v2 = [](std::uint64_t seed) {
    return tests::simulate(tests::paper_case(1), 1e4, seed).solution.moments.v2;
  };
  EXPECT_NE(v2(1), v2(2));
  EXPECT_NE(v2(1), v2(1 + (std::uint64_t{1} << 40)));
  EXPECT_EQ(v2(1), v2(1));
}

TEST(Solve, NormalisesByAllSamplesAndReportsWhatFellOutside) {
  SimulationOptions options;
  options.time = 5e4;
  for (int k = 0; k <= 20; ++k) {
    options.y_edges.push_back(0.05 * k);  // case 1 often exceeds 1
    options.v_edges.push_back(0.04 * k * k / 20 - 0.4);
  }
  const SimulationResult result = simulate_stationary_density(tests::paper_case(1), options);
  const double mass = transform::mass(joint_density(result));
  EXPECT_NEAR(result.solution.mass, mass, 1e-15);
  EXPECT_NEAR(result.summary.outside_fraction, 1 - mass, 1e-15);
  EXPECT_GT(result.summary.outside_fraction, 0.1);
  // A marginal density counts all samples of its variable, for any value of the other variable.
  const double inside_y = integral_of_marginal(estimated_marginal(result, StateVariable::y));
  const double inside_v = integral_of_marginal(estimated_marginal(result, StateVariable::ydot));
  EXPECT_GT(inside_y, mass + 0.02);
  EXPECT_GT(inside_v, mass + 0.02);
  EXPECT_LT(std::max(inside_y, inside_v), 1.0);
  // The moments are independent of the edges.
  options.y_edges.clear();
  options.v_edges.clear();
  const SimulationResult automatic = simulate_stationary_density(tests::paper_case(1), options);
  EXPECT_EQ(automatic.solution.moments.y2, result.solution.moments.y2);
  EXPECT_NEAR(automatic.solution.mass, 1.0, 1e-6);
}

TEST(Solve, HistogramMomentsAndMarginalsAgree) {
  const SimulationResult result = tests::simulate(tests::paper_case(4), 1e5);
  const auto y = transform::marginal(*result.solution.density, StateVariable::y,
                                     joint_density(result).y_edges);
  const auto v = transform::marginal(*result.solution.density, StateVariable::ydot,
                                     joint_density(result).v_edges);
  EXPECT_LT(transform::l1_distance(y, estimated_marginal(result, StateVariable::y)),
            1e-6);  // samples beyond the bins
  EXPECT_LT(transform::l1_distance(v, estimated_marginal(result, StateVariable::ydot)), 1e-6);
  double y1 = 0, v2 = 0;
  for (std::size_t b = 0; b < y.size(); ++b) {
    const double c = v.bin_centre(b), w = v.bin_width(b);
    y1 += y.density[b] * y.bin_width(b) * y.bin_centre(b);
    v2 += v.density[b] * w * (c * c + w * w / 12);
  }
  // Bins of 0.05 sigma_1: the midpoint rule has an error of second order.
  EXPECT_NEAR(y1, result.solution.moments.y1, 1e-3 * y1);
  EXPECT_NEAR(v2, result.solution.moments.v2, 3e-3 * v2);
}

TEST(Solve, ElasticUnderFrequentSmallImpulsesApproachesTheWhiteNoiseDensity) {
  // The excess kurtosis is proportional to 1/lambda; at lambda = 200 it is 2e-3.
  const auto problem = tests::make_problem({.cubic = 1, .restitution = 1, .rate = 200});
  const SimulationResult result = tests::simulate(problem, 3e4);
  const exact::WhiteNoiseDensity exact(problem);
  const auto& y = estimated_marginal(result, StateVariable::y);
  const auto& v = estimated_marginal(result, StateVariable::ydot);
  double y_distance = 0, v_distance = 0;
  for (std::size_t b = 0; b < y.size(); ++b) {
    y_distance +=
        std::abs(y.density[b] - exact.displacement_marginal(y.bin_centre(b))) * y.bin_width(b);
    v_distance +=
        std::abs(v.density[b] - exact.velocity_marginal(v.bin_centre(b))) * v.bin_width(b);
  }
  EXPECT_LT(y_distance, 2 * *result.solution.sampling->y);
  EXPECT_LT(v_distance, 2 * *result.solution.sampling->ydot);
}

TEST(Solve, SamplingErrorPredictsTheDistanceOfTwoRuns) {
  const SimulationResult a = tests::simulate(tests::paper_case(1), 2e5, 11);
  const SimulationResult b = tests::simulate(tests::paper_case(1), 2e5, 12);
  // The distance of two runs is sqrt(2) times the error of one run. Errors of neighbouring bins are
  // correlated, so the distance scatters by some tens of per cent.
  const double y = transform::l1_distance(estimated_marginal(a, StateVariable::y),
                                          estimated_marginal(b, StateVariable::y));
  const double v = transform::l1_distance(estimated_marginal(a, StateVariable::ydot),
                                          estimated_marginal(b, StateVariable::ydot));
  EXPECT_NEAR(y / (std::sqrt(2) * *a.solution.sampling->y), 1.0, 0.4);
  EXPECT_NEAR(v / (std::sqrt(2) * *a.solution.sampling->ydot), 1.0, 0.4);
}

TEST(Solve, AnEmptyBinHasAnUpperBound) {
  const SimulationResult result = tests::simulate(tests::paper_case(1), 1e4);
  const auto& v = estimated_marginal(result, StateVariable::ydot);
  EXPECT_EQ(v.density.front(), 0.0);
  EXPECT_EQ(v.lower.front(), 0.0);
  EXPECT_GT(v.upper.front(), 0.0);
  EXPECT_LT(v.upper.front(), 0.1);
}

// The error estimate of the simulation determines the status, as for other methods.
TEST(Solve, IsOkWithinTheAccuracyAskedForAlone) {
  const auto problem = tests::paper_case(1);
  const auto by_default = simulate_stationary_density(problem, {.time = 1e4}).solution;
  EXPECT_EQ(by_default.status, transform::Status::inaccurate);
  EXPECT_FALSE(by_default.reason.empty());
  EXPECT_TRUE(by_default.density);
  const double error = std::max(*by_default.sampling->y_99, *by_default.sampling->ydot_99);
  EXPECT_GT(error, 0.02);
  EXPECT_TRUE(simulate_stationary_density(problem, {.time = 1e4, .accuracy = 1.01 * error})
                  .solution.has_status_ok());
  EXPECT_EQ(
      simulate_stationary_density(problem, {.time = 1e4, .accuracy = 0.99 * error}).solution.status,
      transform::Status::inaccurate);
  EXPECT_TRUE(simulate_stationary_density(problem, {.time = 1e5}).solution.has_status_ok());
}

TEST(Solve, FillsInTheSolutionAndTheSummary) {
  const SimulationResult result =
      simulate_stationary_density(tests::paper_case(1), {.time = 1e4, .accuracy = 0.1});
  EXPECT_EQ(result.solution.identity, solution_identity(SimulationOptions{}));
  EXPECT_EQ(result.solution.status, transform::Status::ok);
  EXPECT_GT(result.solution.seconds, 0.0);
  EXPECT_EQ(result.solution.metrics, solver_metrics(result.summary));
  EXPECT_GT(result.solution.standard_errors->moments.y2, 0);
  EXPECT_GT(*result.solution.sampling->ydot_99, *result.solution.sampling->ydot);
  EXPECT_TRUE(result.summary.warnings.empty());
  // One impulse per unit time, and two impacts per period of about 6.
  EXPECT_NEAR(static_cast<double>(result.summary.impulses), 1e4, 4e2);
  EXPECT_NEAR(result.summary.impact_rate.mean, 0.33, 0.02);
  EXPECT_NEAR(result.summary.time, 1e4, 300);  // whole samples of each stream
}

TEST(Solve, ReportsProgressToTheEndAndCanBeStoppedByIt) {
  SimulationOptions options;
  options.time = 1e4;
  options.streams = 12;
  std::vector<double> fractions;
  std::vector<SimulationProgress> all;
  options.progress = [&](const SimulationProgress& at) {
    fractions.push_back(at.fraction);
    all.push_back(at);
  };
  const SimulationResult result = simulate_stationary_density(tests::paper_case(1), options);
  ASSERT_EQ(fractions.size(), result.summary.rounds);
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_EQ(fractions.back(), 1.0);
  // The errors in the last progress report equal the errors of the solution.
  EXPECT_EQ(all.back().y_l1, result.solution.sampling->y);
  EXPECT_EQ(all.back().ydot_l1, result.solution.sampling->ydot);
  EXPECT_GT(*all.front().y_l1, *all.back().y_l1);

  int calls = 0;
  options.progress = [&](const SimulationProgress&) {
    ++calls;
    throw std::runtime_error("enough");
  };
  EXPECT_THROW(simulate_stationary_density(tests::paper_case(1), options), std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST(Solve, EndsOnAStopRequestAndReturnsThePresentEstimates) {
  SimulationOptions options;
  options.time = 1e4;
  int asked = 0;
  options.stop = [&] { return ++asked == 3; };
  const SimulationResult result = simulate_stationary_density(tests::paper_case(1), options);
  EXPECT_TRUE(result.summary.interrupted);
  EXPECT_EQ(result.summary.rounds, 3u);
  EXPECT_NEAR(result.summary.time, 3 * 1e4 / 8, 100);
  EXPECT_EQ(result.solution.status, transform::Status::not_converged);  // the goal is not reached
  EXPECT_NE(result.solution.reason.find("interrupted"), std::string::npos);
  EXPECT_NEAR(result.solution.mass, 1, 1e-3);
}

TEST(Solve, RunsUntilTheRequestedSamplesOrErrorAreReached) {
  SimulationOptions options;
  options.samples = 3e4;
  const SimulationResult by_samples = simulate_stationary_density(tests::paper_case(1), options);
  EXPECT_EQ(by_samples.solution.status, transform::Status::ok);
  EXPECT_GE(by_samples.summary.effective_samples, 3e4);
  options.samples.reset();
  options.target_error = 4e-3;
  const SimulationResult by_error = simulate_stationary_density(tests::paper_case(1), options);
  EXPECT_EQ(by_error.solution.status, transform::Status::ok);
  EXPECT_LE(*by_error.solution.sampling->y, 4e-3);
  EXPECT_LE(*by_error.solution.sampling->ydot, 4e-3);
  options.time = 1e4;
  const SimulationResult too_short = simulate_stationary_density(tests::paper_case(1), options);
  EXPECT_EQ(too_short.solution.status, transform::Status::not_converged);
  EXPECT_FALSE(too_short.solution.reason.empty());
  EXPECT_NEAR(too_short.summary.time, 1e4, 300);
}

TEST(Solve, EndsEarlyAtASufficientError) {
  const auto problem = tests::paper_case(1);
  SimulationOptions options{.tails = false, .controlled = true};
  const auto all = simulate_stationary_density(problem, options);
  const double reached = std::max(*all.solution.sampling->y, *all.solution.sampling->ydot);
  options.sufficient_error = 1.6 * reached;
  const auto early = simulate_stationary_density(problem, options);
  EXPECT_TRUE(early.solution.has_status_ok()) << early.solution.reason;
  EXPECT_LE(*early.solution.sampling->y, *options.sufficient_error);
  EXPECT_LE(*early.solution.sampling->ydot, *options.sufficient_error);
  EXPECT_NEAR(early.summary.time, all.summary.time / (1.6 * 1.6), 0.2 * all.summary.time);
  // Even a very large error does not end the simulation before an eighth of its time.
  options.sufficient_error = 1;
  EXPECT_NEAR(simulate_stationary_density(problem, options).summary.time, all.summary.time / 8,
              0.03 * all.summary.time);
  // An error that the default time does not reach is no goal.
  options.sufficient_error = reached / 2;
  const auto missed = simulate_stationary_density(problem, options);
  EXPECT_TRUE(missed.solution.has_status_ok()) << missed.solution.reason;
  EXPECT_EQ(missed.summary.time, all.summary.time);
  options.sufficient_error = 1;
  options.time = all.summary.time / 2;
  EXPECT_NEAR(simulate_stationary_density(problem, options).summary.time, *options.time,
              0.03 * all.summary.time);
}

// The test runs the parts of three processes one after another. Each process simulates only its own
// groups of streams.
TEST(Solve, ProcessesThatShareTheStreamsGiveTheSameBits) {
  const auto problem = tests::paper_case(1);
  SimulationOptions options{.time = 2e4, .streams = 43};
  const auto alone = simulate_stationary_density(problem, options).solution;
  std::vector<std::string> parts;
  for (const int part : {1, 2, 0}) {
    options.process_group = {.part = part, .parts = 3, .gather = [&](const std::string& own) {
                               if (part == 0) return parts;
                               parts.push_back(own);
                               return std::vector<std::string>();
                             }};
    const auto [solution, summary] = simulate_stationary_density(problem, options);
    if (part > 0) {
      EXPECT_FALSE(solution.density);
      continue;
    }
    EXPECT_EQ(solution.moments.y4, alone.moments.y4);
    EXPECT_EQ(solution.standard_errors->moments.v2, alone.standard_errors->moments.v2);
    EXPECT_EQ(solution.estimated_marginals[1].second.density,
              alone.estimated_marginals[1].second.density);
  }
}

TEST(Solve, ProcessesThatShareTheStreamsNeedAFixedTime) {
  SimulationOptions options{.target_error = 1e-3};
  options.process_group.parts = 2;
  EXPECT_THROW(require_valid_simulation(tests::paper_case(1), options), InputError);
}

}  // namespace
}  // namespace fpkcheck::mcs
