#include "mcs/streams/splitting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

Stream stream_at(const problem::Problem& problem, double y, double v) {
  const BinFinder bins({0, 1});
  return {
      .branch =
          {.y = y, .v = v, .until_impulse = 1, .amplitude = 0, .until_sample = 1, .remaining = 1},
      .source = ImpulseSource(problem.impulses, 1, 0),
      .record = StreamRecord(bins, bins)};
}

// U(y) + v^2/2 of k = 1, mu = 4 at (1, 1) is 1/2 + 1 + 1/2 = 2.
TEST(Splitting, MakesFourBranchesForOneAboveEachEnergy) {
  const auto problem = tests::make_problem({.cubic = 4});
  const std::vector<std::size_t> copies{1, 4, 16};
  const std::vector<std::vector<double>> thresholds{{2.1}, {1.9, 2.1}, {1.5, 1.9, 2.1}};
  for (std::size_t levels = 0; levels < copies.size(); ++levels) {
    const Splitting splitting(problem.system.potential(), thresholds[levels], 100);
    Stream stream = stream_at(problem, 1, 1);
    splitting.begin(stream);
    EXPECT_EQ(stream.waiting.size() + 1, copies[levels]);
    EXPECT_EQ(stream.branch.level, static_cast<int>(levels));
    EXPECT_EQ(splitting.weight(stream.branch.level), 1 / static_cast<double>(copies[levels]));
  }
}

TEST(Splitting, EndsABranchThatFallsBelowTheEnergyThatMadeIt) {
  const auto problem = tests::make_problem({.cubic = 4});
  const Splitting splitting(problem.system.potential(), {1.9}, 100);
  Stream stream = stream_at(problem, 1, 1);
  splitting.begin(stream);
  ASSERT_EQ(stream.waiting.size(), 3u);
  stream.branch.v = 0;  // E = 1.5
  splitting.after_impulse(stream);
  EXPECT_EQ(stream.waiting.size(), 2u);
  EXPECT_EQ(stream.branch.level, 1);  // the next one
}

// Where the oscillator is not the paper's.
TEST(Splitting, BranchesGoOnBouncingWhereTheyBegan) {
  const auto problem = tests::make_problem({.cubic = 4});
  const Splitting splitting(problem.system.potential(), {1.9}, 100);
  Stream stream = stream_at(problem, 1, 1);
  stream.general.bouncing = 0.25;
  splitting.begin(stream);
  ASSERT_EQ(stream.waiting.size(), 3u);
  while (!stream.whole()) {
    EXPECT_EQ(stream.general.bouncing, 0.25);
    stream.general.bouncing = -1;
    follow_next(stream);
  }
  EXPECT_EQ(stream.general.bouncing, 0.25);
}

// Energies with P(E > e) = exp(-e): a quarter of them passes from one threshold to the next.
TEST(Splitting, ThresholdsArePassedByAQuarterEach) {
  std::vector<double> edges, weights{0};
  for (int k = 0; k <= 4000; ++k) edges.push_back(0.01 * k);
  for (int k = 0; k < 4000; ++k) weights.push_back(std::exp(-edges[k]) - std::exp(-edges[k + 1]));
  weights.push_back(0);
  const auto thresholds = thresholds_from(BinFinder(edges), weights, 0, 1e-4);
  ASSERT_EQ(thresholds.size(), 6u);  // 4^-6 > 1e-4 > 4^-7
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    EXPECT_NEAR(thresholds[i], static_cast<double>(i + 1) * std::log(4.0), 0.0101);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
