#include "numerics/block_bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fpkcheck::numerics {
namespace {

// x_{k+1} = rho x_k + sqrt(1 - rho^2) xi_k: variance 1 and autocovariances R(k) = rho^|k|, so that
// sum_k R(k) = (1 + rho) / (1 - rho) and G = sum_k |k| R(k) = 2 rho / (1 - rho)^2.
std::vector<double> autoregressive_sequence(double rho, int count, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> sequence{normal(engine)};
  for (int k = 1; k < count; ++k) {
    sequence.push_back(rho * sequence.back() + std::sqrt(1 - rho * rho) * normal(engine));
  }
  return sequence;
}

TEST(BlockBootstrap, HasTheBlockLengthOfAnAutoregressiveSequence) {
  constexpr int kCount = 100'000;
  for (const double rho : {0.5, 0.9, -0.5}) {
    const double g = 2 * rho / std::pow(1 - rho, 2), spectrum = (1 + rho) / (1 - rho);
    const double exact = std::cbrt(2 * g * g / (4 * spectrum * spectrum / 3) * kCount);
    const auto length = bootstrap_block_length(autoregressive_sequence(rho, kCount, 1));
    EXPECT_NEAR(length.value() / exact, 1, 0.2) << rho;
  }
  EXPECT_LT(bootstrap_block_length(autoregressive_sequence(0, kCount, 1)).value(), 4);
  EXPECT_EQ(bootstrap_block_length(std::vector<double>(50, 2.0)), 1);
  EXPECT_FALSE(bootstrap_block_length(autoregressive_sequence(0.99, 300, 1)));
}

// The variance of the mean of n correlated numbers is (1 + rho) / (1 - rho) / n.
TEST(BlockBootstrap, HasTheVarianceOfTheMean) {
  constexpr int kCount = 50'000, kSequences = 10;
  constexpr std::size_t kReplicates = 500;
  const double rho = 0.8, exact = (1 + rho) / (1 - rho) / kCount;
  double variance = 0;
  for (unsigned seed = 1; seed <= kSequences; ++seed) {
    const auto sequence = autoregressive_sequence(rho, kCount, seed);
    const auto blocks = static_cast<std::size_t>(kCount / bootstrap_block_length(sequence).value());
    BlockAverages averages{1, std::vector<double>(blocks)};
    double mean = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
      const std::size_t from = k * kCount / blocks, to = (k + 1) * kCount / blocks;
      for (std::size_t i = from; i < to; ++i) {
        averages.averages[k] += sequence[i] / static_cast<double>(to - from);
        mean += sequence[i] / kCount;
      }
    }
    for (const double replicate : bootstrap_replicates(averages, kReplicates)) {
      variance += std::pow(replicate - mean, 2) / kReplicates / kSequences;
    }
  }
  EXPECT_NEAR(variance / exact, 0.97, 0.1);
}

}  // namespace
}  // namespace fpkcheck::numerics
