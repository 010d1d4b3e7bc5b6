#include "mcs/estimate/stream_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fpkcheck::mcs {
namespace {

const std::vector<double> kExcess{0.3, -0.1, 0.2, -0.4, 0.1, 0.25, -0.3, 0.15, 0.05};

TEST(StreamWeights, SumToOneAndCancelTheExcess) {
  const TrajectoryStreamWeights weights(kExcess);
  double sum = 0, weighted = 0;
  for (std::size_t s = 0; s < kExcess.size(); ++s) {
    EXPECT_GT(weights[s], 0.0);
    sum += weights[s];
    weighted += weights[s] * kExcess[s];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_NEAR(weighted, 0.0, 1e-16);
}

TEST(StreamWeights, RecoverAMeanThatDependsLinearlyOnTheExcess) {
  std::vector<double> values;
  for (const double b : kExcess) values.push_back(7 + 3 * b);
  const MeanEstimate estimate = TrajectoryStreamWeights(kExcess).estimate_mean(values);
  EXPECT_NEAR(estimate.mean, 7.0, 1e-14);
  EXPECT_NEAR(estimate.standard_error, 0.0, 1e-14);
}

TEST(StreamWeights, ArePlainForEqualExcessPowers) {
  const TrajectoryStreamWeights weights(std::vector<double>(8, 0.0));
  for (std::size_t s = 0; s < weights.size(); ++s) EXPECT_DOUBLE_EQ(weights[s], 1.0 / 8);
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8};
  const MeanEstimate estimate = weights.estimate_mean(values),
                     plain = estimate_unweighted_mean(values);
  EXPECT_DOUBLE_EQ(estimate.mean, 4.5);
  EXPECT_DOUBLE_EQ(plain.mean, 4.5);
  EXPECT_DOUBLE_EQ(plain.standard_error, std::sqrt(6.0 / 8));
  // Two slopes leave five degrees of freedom instead of seven.
  EXPECT_DOUBLE_EQ(estimate.standard_error, plain.standard_error * std::sqrt(7.0 / 5));
  EXPECT_NEAR(weights.confidence_interval_factor(), 2.570582, 1e-6);  // Student's t
}

// Many experiments with 16 streams each: x = 2 + 3 b + b^2 + noise, b skewed with mean zero. The
// residual b^2 depends on b, so a single slope for all streams would be biased.
TEST(StreamWeights, AreUnbiasedAndTheirIntervalsCoverTheTruth) {
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  std::exponential_distribution<double> skewed;
  constexpr int kTrials = 20000;
  int covered = 0;
  double sum = 0, sum_of_squares = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> excess, values;
    for (int s = 0; s < 16; ++s) {
      const double b = 0.2 * (skewed(engine) - 1);
      excess.push_back(b);
      values.push_back(2 + 3 * b + (b * b - 0.04) + 0.2 * normal(engine));
    }
    const TrajectoryStreamWeights weights(excess);
    const MeanEstimate estimate = weights.estimate_mean(values);
    covered += std::abs(estimate.mean - 2) <
               weights.confidence_interval_factor() * estimate.standard_error;
    sum += estimate.mean - 2;
    sum_of_squares += (estimate.mean - 2) * (estimate.mean - 2);
  }
  EXPECT_NEAR(sum / kTrials, 0.0, 4 * std::sqrt(sum_of_squares) / kTrials);
  // For a skewed law 16 streams are few: the coverage may lose one or two per cent.
  EXPECT_NEAR(static_cast<double>(covered) / kTrials, 0.95, 0.02);
}

}  // namespace
}  // namespace fpkcheck::mcs
