#include "mcs/estimate/density_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"

namespace fpkcheck::mcs {
namespace {

const double kMeanOfAbsolute = std::sqrt(2 / std::numbers::pi);

// With one bin, or with fully correlated bins, the distance is the absolute value of one normal
// variable.
TEST(L1SamplingError, OfCorrelatedErrorsScattersMost) {
  const std::vector<std::vector<double>> together(50, std::vector<double>(16, 0.01));
  const double deviation = 50 * 0.01 * 4;
  const L1SamplingError distance = l1_sampling_error(together);
  EXPECT_NEAR(distance.expected, kMeanOfAbsolute * deviation, 1e-12);
  EXPECT_NEAR(distance.quantile_99, 2.576 * deviation, 0.35 * deviation);
}

// With independent bins the distance is a sum of many terms and close to its mean.
TEST(L1SamplingError, OfIndependentErrorsIsNearItsMean) {
  std::vector<std::vector<double>> apart(400, std::vector<double>(400, 0.0));
  for (std::size_t b = 0; b < apart.size(); ++b) apart[b][b] = 0.01;
  const L1SamplingError distance = l1_sampling_error(apart);
  EXPECT_NEAR(distance.expected, kMeanOfAbsolute * 4, 1e-12);
  // The standard deviation of |x| is 0.603 times the standard deviation of x; the 99 % quantile is
  // 2.33 deviations above the mean.
  EXPECT_NEAR(distance.quantile_99, kMeanOfAbsolute * 4 + 2.33 * 0.603 * 0.01 * 20, 0.1);
}

// Compares the stated quantile with 20 runs: at most two of the 40 distances from the mean of all
// runs exceed the 99 % quantile.
TEST(L1SamplingError, PredictsTheErrorsOfIndependentRuns) {
  std::vector<SimulationResult> runs;
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
        distance += std::abs(marginal.density[b] - mean[b]) * marginal.bin_width(b);
      }
      const auto which = run.solution.estimated_marginals[variable].first;
      ratio += distance / *expected_l1_error(*run.solution.sampling, which) / (2 * kRuns);
      beyond += distance > *l1_error_quantile_99(*run.solution.sampling, which);
    }
  }
  EXPECT_LE(beyond, 2);
  EXPECT_NEAR(ratio, 1, 0.2);
}

}  // namespace
}  // namespace fpkcheck::mcs
