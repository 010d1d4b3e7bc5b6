#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solved_run.hpp"
#include "workflows/check/quantities.hpp"

namespace fpkcheck::check {
namespace {

using compare::Distances;
using tests::kinds;
using tests::moved_by;
using tests::solution;
using Kinds = std::vector<QuantityKind>;

TEST(DistanceClaims, EveryDistanceOfAPairIsFound) {
  for (double Distances::*distance :
       {&Distances::l1, &Distances::l2, &Distances::sup, &Distances::hellinger, &Distances::kl}) {
    EXPECT_EQ(kinds(moved_by(
                  [&](results::Run& run) { run.cases[0].pairs[0].distances.*distance += 1e-7; })),
              Kinds{QuantityKind::distance});
  }
  EXPECT_EQ(kinds(moved_by([](results::Run& run) {
              run.cases[0].pairs[0].distances.log10_tail[2].mean_abs += 3e-6;
            })),
            Kinds{QuantityKind::tail});
}

TEST(DistanceClaims, ATailThatIsNotThereAndOtherBinsAreFound) {
  EXPECT_GT(moved_by([](results::Run& run) {
              for (auto& pair : run.cases[0].pairs) pair.distances.log10_tail.clear();
            }).size(),
            50u);
  const auto other_bins =
      moved_by([](results::Run& run) { ++run.cases[0].pairs[0].distances.log10_tail[1].bins; });
  ASSERT_EQ(other_bins.size(), 1u);
  EXPECT_TRUE(other_bins[0].name.starts_with("tail p(y) to"));
}

TEST(DistanceClaims, APairInTheOtherOrderIsAnother) {
  const auto found = moved_by([](results::Run& run) {
    auto& pair = run.cases[0].pairs[0];
    std::swap(pair.a, pair.b);
  });
  EXPECT_EQ(found.size(), 2u);
}

TEST(DistanceClaims, IgnoresADivergenceThatIsInfiniteInOneRun) {
  EXPECT_TRUE(moved_by([](results::Run& run) {
                run.cases[0].pairs[0].distances.kl = std::numeric_limits<double>::infinity();
              }).empty());
}

TEST(DistanceClaims, DistancesToASimulationMoveWithItsSamplingError) {
  const auto by = [](double l1) {
    return moved_by([&](results::Run& run) {
      for (auto& [a, b, variable, distances, error] : run.cases[0].pairs) {
        if (b != "mcs" || variable != transform::Variable::y || a != "fd-kf") continue;
        distances.l1 += l1;
        distances.kl += l1;  // not compared with a simulation
      }
    });
  };
  results::Run run = tests::paper_baseline();
  const auto& sampling = *solution(run, "mcs").sampling;
  const double expected = std::sqrt(2.0) * *sampling.y,
               quantile_99 = std::sqrt(2.0) * *sampling.y_99;
  const double allowed = expected + 4 * (quantile_99 - expected) / 2.326;
  EXPECT_GT(allowed, quantile_99);
  EXPECT_EQ(by(0.98 * allowed).size(), 0u);
  EXPECT_EQ(kinds(by(1.02 * allowed)), Kinds{QuantityKind::simulated_l1});
}

}  // namespace
}  // namespace fpkcheck::check
