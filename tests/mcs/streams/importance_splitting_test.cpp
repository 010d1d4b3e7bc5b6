#include "mcs/streams/importance_splitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"

namespace fpkcheck::mcs {
namespace {

TrajectoryStream make_stream(const problem::Problem& problem, double y, double v) {
  const BinFinder bins({0, 1});
  return {.branch = {.y = y,
                     .v = v,
                     .time_to_impulse = 1,
                     .amplitude = 0,
                     .time_to_sample = 1,
                     .remaining = 1},
          .source = ImpulseSource(problem.impulses, 1, 0),
          .record = TrajectoryStreamStatistics(bins, bins)};
}

/// Resumes every branch of a stream without advancing the branch, and computes the number and the
/// total weight of the branches.
struct Followed {
  std::size_t branches = 1;
  double weight = 0;

  Followed(const ImportanceSplitting& splitting, TrajectoryStream& stream)
      : weight(splitting.branch_statistical_weight(stream.branch)) {
    for (; !stream.is_on_main_branch(); ++branches) {
      resume_pending_branch(stream);
      weight += splitting.branch_statistical_weight(stream.branch);
    }
  }
};

// For k = 1 and mu = 4 the energy U(y) + v^2/2 at (1, 1) is 1/2 + 1 + 1/2 = 2.
TEST(ImportanceSplitting, MakesFourBranchesForOneAboveEachEnergy) {
  const auto problem = tests::make_problem({.cubic = 4});
  const std::vector<std::size_t> copies{1, 4, 16};
  const std::vector<std::vector<double>> thresholds{{2.1}, {1.9, 2.1}, {1.5, 1.9, 2.1}};
  for (std::size_t threshold_count = 0; threshold_count < copies.size(); ++threshold_count) {
    const ImportanceSplitting splitting(problem.system.potential(), thresholds[threshold_count],
                                        100);
    TrajectoryStream stream = make_stream(problem, 1, 1);
    splitting.split_initial_state(stream);
    EXPECT_EQ(stream.branch.energy_level, static_cast<int>(threshold_count));
    EXPECT_EQ(splitting.branch_statistical_weight(stream.branch),
              1 / static_cast<double>(copies[threshold_count]));
    const Followed all(splitting, stream);
    EXPECT_EQ(all.branches, copies[threshold_count]);
    EXPECT_EQ(all.weight, 1);
  }
}

TEST(ImportanceSplitting, EndsABranchThatFallsBelowTheEnergyThatMadeIt) {
  const auto problem = tests::make_problem({.cubic = 4});
  const ImportanceSplitting splitting(problem.system.potential(), {1.9}, 100);
  TrajectoryStream stream = make_stream(problem, 1, 1);
  splitting.split_initial_state(stream);
  stream.branch.v = 0;  // E = 1.5
  splitting.split_or_end_branch_by_energy(stream);
  EXPECT_EQ(stream.branch.energy_level, 1);  // energy level of the next branch
  EXPECT_EQ(Followed(splitting, stream).branches, 3u);
}

TEST(ImportanceSplitting, BranchesGoOnBouncingWhereTheyBegan) {
  const auto problem = tests::make_problem({.cubic = 4});
  const ImportanceSplitting splitting(problem.system.potential(), {1.9}, 100);
  TrajectoryStream stream = make_stream(problem, 1, 1);
  stream.branch.time_to_rest = 0.25;
  splitting.split_initial_state(stream);
  ASSERT_FALSE(stream.is_on_main_branch());
  while (!stream.is_on_main_branch()) {
    EXPECT_EQ(stream.branch.time_to_rest, 0.25);
    stream.branch.time_to_rest = -1;
    resume_pending_branch(stream);
  }
  EXPECT_EQ(stream.branch.time_to_rest, 0.25);
}

// A long-tailed law crosses all thresholds with one impulse; 4^12 branches would be 17 million.
TEST(ImportanceSplitting, AnImpulseAcrossManyEnergiesMakes64Branches) {
  const auto problem = tests::make_problem({.cubic = 4});
  std::vector<double> thresholds;
  for (int i = 0; i < 12; ++i) thresholds.push_back(0.1 * (i + 1));
  const ImportanceSplitting splitting(problem.system.potential(), thresholds, 100);
  TrajectoryStream stream = make_stream(problem, 1, 0);
  stream.branch.v = 1;  // E = 2
  splitting.split_initial_state(stream);
  EXPECT_EQ(stream.branch.energy_level, 12);
  EXPECT_LE(stream.pending_branches.size(), 4u);
  const Followed all(splitting, stream);
  EXPECT_EQ(all.branches, 64u);
  EXPECT_EQ(all.weight, 1);
}

/// A chain v -> a v + jump with a long-tailed law of the jumps, instead of an oscillator: weighted
/// time averages over `steps` steps of one stream.
struct Walk {
  double weight = 0;
  std::array<double, 3> above{};  // for the speeds kSpeeds
  std::size_t most_waiting = 0;
  std::uint64_t impulses = 0, branch_impulses = 0;

  static constexpr std::array<double, 3> kSpeeds{2, 4, 7};

  Walk(const ImportanceSplitting& splitting, int steps, std::uint64_t seed) {
    boost::random::mt19937_64 engine(seed);
    boost::random::uniform_01<double> unit;
    const auto problem = tests::make_problem({});
    TrajectoryStream stream = make_stream(problem, 0, 0);
    stream.branch.remaining = steps;
    splitting.split_initial_state(stream);
    for (;;) {
      TrajectoryBranch& branch = stream.branch;
      if (branch.remaining <= 0) {
        if (stream.is_on_main_branch()) break;
        resume_pending_branch(stream);
        continue;
      }
      branch.remaining -= 1;
      const double counted = splitting.branch_statistical_weight(branch) / steps;
      weight += counted;
      for (std::size_t k = 0; k < above.size(); ++k)
        above[k] += branch.v > kSpeeds[k] ? counted : 0;
      branch.v = 0.8 * branch.v - (unit(engine) < 0.2 ? std::log(1 - unit(engine)) : 0);
      ++(stream.is_on_main_branch() ? stream.record.impulses : stream.record.branch_impulses);
      splitting.split_or_end_branch_by_energy(stream);
      most_waiting = std::max(most_waiting, stream.pending_branches.size());
    }
    impulses = stream.record.impulses;
    branch_impulses = stream.record.branch_impulses;
  }
};

struct Walks {
  MeanEstimate weight{};
  std::array<MeanEstimate, Walk::kSpeeds.size()> above{};
  std::size_t most_waiting = 0;
  double most_for_one =
      0;  // branch impulses per impulse of the main branch, beyond kBranchImpulseAllowance

  Walks(const std::vector<double>& thresholds, int count, int steps) {
    const ImportanceSplitting splitting(numerics::Polynomial({0, 0, 0.5}), thresholds, 1e4);
    std::vector<double> weights;
    std::array<std::vector<double>, Walk::kSpeeds.size()> all;
    for (int k = 0; k < count; ++k) {
      const Walk walk(splitting, steps, static_cast<std::uint64_t>(k + 1));
      weights.push_back(walk.weight);
      for (std::size_t i = 0; i < all.size(); ++i) all[i].push_back(walk.above[i]);
      most_waiting = std::max(most_waiting, walk.most_waiting);
      const double beyond = static_cast<double>(walk.branch_impulses) -
                            static_cast<double>(ImportanceSplitting::kBranchImpulseAllowance);
      most_for_one = std::max(most_for_one, beyond / static_cast<double>(walk.impulses));
    }
    weight = estimate_unweighted_mean(weights);
    std::ranges::transform(all, above.begin(),
                           [](const auto& of) { return estimate_unweighted_mean(of); });
  }
};

// Thresholds with a probability ratio of 1/4, and much closer thresholds: the number of branches is
// bounded, and the weighted averages equal those without splitting.
TEST(ImportanceSplitting, IsUnbiasedWithinItsBoundsWhereverTheThresholdsAre) {
  std::vector<double> apart, close;
  for (int i = 0; i < 12; ++i) {
    apart.push_back(std::pow(2 + 1.6 * i, 2) / 2);
    close.push_back(std::pow(1 + 0.4 * i, 2) / 2);
  }
  const Walks plain({}, 100, 20000);
  EXPECT_EQ(plain.most_waiting, 0u);
  for (const auto& thresholds : {apart, close}) {
    SCOPED_TRACE(thresholds == close ? "close" : "apart");
    const Walks split(thresholds, 100, 1000);
    EXPECT_LE(split.most_waiting, 12u * 15u / 2);
    EXPECT_LT(split.most_for_one, 1.1 * 12 * ImportanceSplitting::kBranchImpulsesPerThreshold);
    if (thresholds == close) {  // the bound is active
      EXPECT_GT(split.most_for_one, 0.8 * 12 * ImportanceSplitting::kBranchImpulsesPerThreshold);
    }
    tests::expect_within_four_errors(split.weight.mean, 1, split.weight.standard_error, "all");
    for (std::size_t i = 0; i < split.above.size(); ++i) {
      const MeanEstimate &one = split.above[i], &other = plain.above[i];
      tests::expect_within_four_errors(
          one.mean, other.mean, std::hypot(one.standard_error, other.standard_error), "tail");
    }
  }
}

// Energies with P(E > e) = exp(-e): thresholds have a probability ratio of 1/4.
TEST(ImportanceSplitting, ThresholdsArePassedByAQuarterEach) {
  std::vector<double> edges, weights{0};
  for (int k = 0; k <= 4000; ++k) edges.push_back(0.01 * k);
  for (int k = 0; k < 4000; ++k) weights.push_back(std::exp(-edges[k]) - std::exp(-edges[k + 1]));
  weights.push_back(0);
  const auto thresholds = choose_energy_thresholds(BinFinder(edges), weights, 0, 1e-4);
  ASSERT_EQ(thresholds.size(), 6u);  // 4^-6 > 1e-4 > 4^-7
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    EXPECT_NEAR(thresholds[i], static_cast<double>(i + 1) * std::log(4.0), 0.0101);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
