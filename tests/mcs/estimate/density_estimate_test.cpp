#include "mcs/estimate/density_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"
#include "statistics.hpp"

namespace fpkcheck::mcs {
namespace {

const double kMeanOfAbsolute = std::sqrt(2 / std::numbers::pi);

// One bin, or many that err together: the distance is the modulus of one normal variable.
TEST(SamplingL1, OfErrorsThatGoTogetherScattersMost) {
  const std::vector<std::vector<double>> together(50, std::vector<double>(16, 0.01));
  const double deviation = 50 * 0.01 * 4;
  const SamplingL1 distance = sampling_l1(together);
  EXPECT_NEAR(distance.expected, kMeanOfAbsolute * deviation, 1e-12);
  EXPECT_NEAR(distance.in_99, 2.576 * deviation, 0.35 * deviation);
}

// Each bin errs by itself: the distance is a sum of many, hardly above its mean.
TEST(SamplingL1, OfIndependentErrorsIsNearItsMean) {
  std::vector<std::vector<double>> apart(400, std::vector<double>(400, 0.0));
  for (std::size_t b = 0; b < apart.size(); ++b) apart[b][b] = 0.01;
  const SamplingL1 distance = sampling_l1(apart);
  EXPECT_NEAR(distance.expected, kMeanOfAbsolute * 4, 1e-12);
  // Deviation of |x| is 0.603 of x's, and 2.33 of them lie below 99 %.
  EXPECT_NEAR(distance.in_99, kMeanOfAbsolute * 4 + 2.33 * 0.603 * 0.01 * 20, 0.1);
}

// What a run says of itself, against other runs: 20 of them, none further from the mean of all than
// it may be once in a hundred times, but for two of the forty distances at the most.
TEST(SamplingL1, ForetellsHowFarRunsGoAstray) {
  std::vector<Result> runs;
  constexpr int kRuns = 20;
  for (int k = 0; k < kRuns; ++k) {
    runs.push_back(tests::simulate(tests::paper_case(4), 2e4, 100 + k));
  }
  int beyond = 0;
  double ratio = 0;
  for (const int variable : {0, 1}) {
    const auto& first = runs[0].solution.estimated_marginals[variable].second;
    std::vector<double> mean(first.size());
    for (const auto& run : runs) {
      for (std::size_t b = 0; b < mean.size(); ++b) {
        mean[b] += run.solution.estimated_marginals[variable].second.density[b] / kRuns;
      }
    }
    for (const auto& run : runs) {
      const auto& marginal = run.solution.estimated_marginals[variable].second;
      double distance = 0;
      for (std::size_t b = 0; b < mean.size(); ++b) {
        distance += std::abs(marginal.density[b] - mean[b]) * marginal.width(b);
      }
      const auto which = run.solution.estimated_marginals[variable].first;
      ratio += distance / *expected(*run.solution.sampling, which) / (2 * kRuns);
      beyond += distance > *in_99(*run.solution.sampling, which);
    }
  }
  EXPECT_LE(beyond, 2);
  EXPECT_NEAR(ratio, 1, 0.2);
}

}  // namespace
}  // namespace fpkcheck::mcs
