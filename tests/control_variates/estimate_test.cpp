#include "control_variates/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/linear_density.hpp"
#include "exact/linear_moments.hpp"
#include "exact/linear_problem.hpp"
#include "prepared_case.hpp"

namespace fpkcheck::control_variates {
namespace {

constexpr int kY2 = 1, kV1 = 3, kV2 = 4;  // indices in kMoments

void expect_covers_truth(const EstimatesWithAndWithoutControlVariates& e, double truth,
                         double truth_error = 0) {
  EXPECT_GT(e.controlled.standard_error, 0);
  EXPECT_NEAR(e.controlled.mean, truth, 4 * e.controlled.standard_error + truth_error);
}

double standard_error_reduction(const EstimatesWithAndWithoutControlVariates& e) {
  return std::pow(e.plain.standard_error / e.controlled.standard_error, 2);
}

TEST(ControlVariates, ReducesTheVarianceInCase1) {
  const ControlVariateResult result = tests::prepared_case_1().simulate_and_estimate(2e5);
  expect_covers_truth(result.estimates.moments[kY2], tests::kTrueY2, 1e-9);
  expect_covers_truth(result.estimates.moments[kV2], tests::kTrueV2, 1e-9);
  EXPECT_GT(standard_error_reduction(result.estimates.moments[kY2]), 1e8);
  EXPECT_GT(standard_error_reduction(result.estimates.moments[kV2]), 1e8);
  // L y = v: the controlled estimate has no sampling error.
  EXPECT_LT(std::abs(result.estimates.moments[kV1].controlled.mean), 1e-10);
  EXPECT_GT(
      std::pow(result.estimates.v.plain_l1.expected / result.estimates.v.controlled_l1.expected, 2),
      1e4);
  EXPECT_GT(
      std::pow(result.estimates.y.plain_l1.expected / result.estimates.y.controlled_l1.expected, 2),
      1e2);
}

TEST(ControlVariates, IsUnbiasedWithControlFunctionsThatAreWrong) {
  // Control functions wrong by a tenth leave a tenth of the error; the factor 0 gives the plain
  // estimate.
  for (const double factor : {1.1, 0.9, 0.0}) {
    const ControlVariateResult result =
        tests::prepared_case_1().with_scaled_control(factor).simulate_and_estimate(2e5);
    const EstimatesWithAndWithoutControlVariates& e = result.estimates.moments[kY2];
    expect_covers_truth(e, tests::kTrueY2, 1e-9);
    expect_covers_truth(result.estimates.moments[kV2], tests::kTrueV2, 1e-9);
    EXPECT_NEAR(e.controlled.standard_error / e.plain.standard_error, std::abs(1 - factor), 1e-4);
  }
}

TEST(ControlVariates, AgreesWithTheExactLinearOscillator) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    SCOPED_TRACE(law);
    const tests::PreparedCase linear(tests::linear_problem({.law = law}));
    const ControlVariateResult result = linear.simulate_and_estimate(1e5);
    const auto exact = exact::linear_moments_at(linear.problem, {}, 1e4);
    expect_covers_truth(result.estimates.moments[kY2], exact.zz, 1e-12);
    expect_covers_truth(result.estimates.moments[kV2], exact.vv, 1e-12);
    EXPECT_GT(standard_error_reduction(result.estimates.moments[kY2]), 1e6);
  }
}

TEST(ControlVariates, SmoothBinsAgreeWithTheExactLinearDensity) {
  const tests::PreparedCase linear(tests::linear_problem());
  const ControlVariateResult result = linear.simulate_and_estimate(2e5);
  const exact::LinearDensity density(linear.problem);
  // Averages over fine bins, weighted by the spline at the bin centres, have an error of second
  // order.
  const auto compare = [&](const SmoothBinAverageEstimates& bins, double from,
                           const auto& averages) {
    constexpr int kFine = 200;
    for (int b = 0; b < bins.bins.count; ++b) {
      const double centre = bins.bins.first + b * bins.bins.spacing;
      const double begin = std::max(from, centre - 2 * bins.bins.spacing);
      const double width = (centre + 2 * bins.bins.spacing - begin) / kFine;
      std::vector<double> edges;
      for (int k = 0; k <= kFine; ++k) edges.push_back(begin + k * width);
      const auto p = averages(edges);
      double sum = 0, weight = 0;
      for (int k = 0; k < kFine; ++k) {
        const double m = transform::cardinal_cubic_spline((begin + (k + 0.5) * width - centre) /
                                                          bins.bins.spacing);
        sum += m * p[k];
        weight += m;
      }
      const auto& e = bins.averages[b].controlled;
      EXPECT_NEAR(e.mean, sum / weight, 4.5 * e.standard_error + 2e-6) << centre;
      EXPECT_LT(e.standard_error, 2e-4 + 0.1 * (sum / weight));
    }
  };
  compare(result.estimates.y, 0, [&](const auto& e) { return density.displacement_averages(e); });
  compare(result.estimates.v, -1e9, [&](const auto& e) { return density.velocity_averages(e); });
}

TEST(ControlVariates, HoldsForLossesRareImpulsesAndAMean) {
  // The reference is U of the fit, which is independent of the simulation.
  for (const tests::Parameters& p :
       {tests::Parameters{.restitution = 0.5}, tests::Parameters{.rate = 0.3},
        tests::Parameters{.mean = 0.15}, tests::Parameters{.cubic = 1, .intensity = 1}}) {
    const tests::PreparedCase other(tests::make_problem(p));
    const ControlVariateResult result = other.simulate_and_estimate(1e5);
    const EstimatesWithAndWithoutControlVariates& e = result.estimates.moments[kY2];
    EXPECT_GT(standard_error_reduction(e), 1e4);
    EXPECT_NEAR(e.controlled.mean, result.backward_means[kY2], 1e-4 * e.controlled.mean);
    EXPECT_TRUE(result.checks.failed_check_names().empty())
        << result.checks.failed_check_names().front();
  }
}

TEST(ControlVariates, IsPlainWithoutControlFunctions) {
  const auto note = [](const problem::Problem& problem, mcs::SimulationOptions options,
                       ControlVariateSplineCellCounts cells) {
    options.controlled = true;
    options.streams = 8;
    const auto solution =
        simulate_with_control_variates(problem, {.simulation = options, .cells = cells});
    EXPECT_TRUE(solution.smooth_estimates.empty());
    EXPECT_FALSE(solution.smooth_sampling);
    return transform::metric_text(solution.metrics, "notes[0]").value_or("");
  };
  const std::string not_taken = "plain simulation without control variates: ";
  const auto problem = tests::paper_case(1);
  EXPECT_EQ(note(problem, {.equation = mcs::DensityEquation::white, .time = 2e3}, {20, 40}),
            not_taken + "control functions exist for impulses without splitting only");
  EXPECT_EQ(note(problem, {.time = 2e3, .tails = true}, {20, 40}),
            not_taken + "control functions exist for impulses without splitting only");
  EXPECT_EQ(note(tests::make_problem({.rate = 100}), {.time = 20}, {3000, 40}),
            not_taken + "impulses this small need too much memory");
}

// Eight streams are too few for Hotelling's test on 14 polynomials.
TEST(ControlVariates, LimitsTheGeneratorTestByTheNumberOfStreams) {
  const mcs::SimulationOptions few{.time = 5e3, .streams = 8};
  const auto solution = simulate_with_control_variates(
      tests::paper_case(1), {.simulation = few, .cells = ControlVariateSplineCellCounts{20, 40}});
  EXPECT_TRUE(solution.has_status_ok()) << solution.reason;
  EXPECT_EQ(transform::metric_number(solution.metrics, "checks.generator.dimensions"), 4);
  const double p = *transform::metric_number(solution.metrics, "checks.generator.p_value");
  EXPECT_GT(p, 0);
  EXPECT_LT(p, 1);
}

// The mean of the impulses keeps the mass off the wall: checks of impacts pass without impacts.
TEST(ControlVariates, SupportsProblemsWithoutImpacts) {
  const auto problem = tests::make_problem({.cubic = 0, .rate = 500, .mean = 0.01273});
  const auto solution = simulate_with_control_variates(
      problem, {.simulation = {.time = 2e3, .accuracy = 0.1, .streams = 16},
                .cells = ControlVariateSplineCellCounts{20, 40}});
  EXPECT_TRUE(solution.has_status_ok()) << solution.reason;
  EXPECT_EQ(transform::metric_number(solution.metrics, "checks.impacts.restitution"), 0);
}

// A caller may end the simulation once the progress exceeds 0. The fit must be complete then; here
// it takes a hundred times as long as the simulation.
TEST(ControlVariates, ReportsProgressAfterTheFit) {
  const auto furthest = [](int threads) {
    double fraction = -1;
    simulate_with_control_variates(tests::paper_case(1),
                                   {.simulation = {.time = 2e3,
                                                   .threads = threads,
                                                   .streams = 8,
                                                   .progress =
                                                       [&](const mcs::SimulationProgress& at) {
                                                         fraction = std::max(fraction, at.fraction);
                                                       }},
                                    .cells = ControlVariateSplineCellCounts{60, 120}});
    return fraction;
  };
  EXPECT_EQ(furthest(2), 0);
  EXPECT_EQ(furthest(1), 1);
}

TEST(ControlVariates, SolvesInOneCall) {
  const auto problem = tests::paper_case(1);
  const mcs::SimulationOptions simulation{.time = 5e4, .streams = 32};
  const auto solution = simulate_with_control_variates(
      problem, {.simulation = simulation, .cells = ControlVariateSplineCellCounts{24, 48}});
  EXPECT_TRUE(solution.has_status_ok()) << solution.reason;
  const double error = solution.standard_errors->moments.y2;
  EXPECT_LT(error, 1e-6);
  EXPECT_NEAR(solution.moments.y2, tests::kTrueY2, 4 * error + 1e-9);
  // The plain estimate and the histogram equal those of mcs alone with the same step.
  mcs::SimulationOptions plain = simulation;
  plain.step = 0.5;
  const auto alone = mcs::simulate_stationary_density(problem, plain).solution;
  EXPECT_NEAR(*transform::metric_number(solution.metrics, "plain.moments.y2"), alone.moments.y2,
              4 * alone.standard_errors->moments.y2);
  EXPECT_EQ(solution.estimated_marginals[0].second.density,
            alone.estimated_marginals[0].second.density);
  const auto* smooth =
      transform::find_smooth_bin_estimate(solution, transform::StateVariable::ydot);
  ASSERT_NE(smooth, nullptr);
  EXPECT_EQ(static_cast<int>(smooth->averages.size()), smooth->bins.count);
  EXPECT_GT(*solution.smooth_sampling->y_99, *solution.smooth_sampling->y);
  EXPECT_LT(*solution.smooth_sampling->y, 0.5 * *solution.sampling->y);
}

constexpr transform::SmoothBins kBins{.first = -0.2, .spacing = 0.2, .count = 8};

TEST(EstimatedFunctionals, AreWhatTheDepositHolds) {
  const EstimatedFunctionals functionals{.y_bins = kBins, .v_bins = {-1, 0.5, 5}};
  const auto functions = functionals.integrands_of_functionals();
  EXPECT_EQ(static_cast<int>(functions.size()), functionals.functional_count());
  mcs::DepositedSumsOfTrajectory stream;
  stream.samples = 4;
  for (std::size_t p = 0; p < mcs::kRecordedMomentPowers.size(); ++p)
    stream.powers[p] = 4.0 * static_cast<double>(1 + p);
  mcs::SampleDepositionGrid grid;
  grid.y_bins = functionals.y_bins;
  grid.v_bins = functionals.v_bins;
  stream.sums.y_bins.assign(20, 0);
  stream.sums.v_bins.assign(20, 0);
  stream.sums.y_bins[mcs::DepositedSampleSums::kBinOffset + 3] = 2;
  stream.sums.v_bins[mcs::DepositedSampleSums::kBinOffset + 4] = 1;
  const auto means = functionals.functional_means_in_stream(stream);
  EXPECT_EQ(means[0], 1);   // y
  EXPECT_EQ(means[1], 3);   // y^2
  EXPECT_EQ(means[2], 10);  // y^4
  EXPECT_EQ(means[3], 2);   // v
  EXPECT_EQ(means[4], 5);   // v^2
  EXPECT_EQ(means[5], 14);  // v^4
  EXPECT_EQ(means[6 + 3], 0.5);
  EXPECT_EQ(means[6 + 8 + 4], 0.25);
  EXPECT_NEAR(functions[2].y_factor(2) * functions[2].v_factor(7), 16, 1e-12);
  EXPECT_NEAR(functions[6 + 3].y_factor(0.4), 2.0 / 3, 1e-15);
  EXPECT_NEAR(functions[6 + 8 + 4].v_factor(1), 2.0 / 3, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::control_variates
