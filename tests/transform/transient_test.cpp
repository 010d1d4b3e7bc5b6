#include "transform/transient.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::transform {
namespace {

// A density over two bins of width 1, with the probability p in the first bin, and E[y^2] = y2.
TransientDensitySnapshot snapshot(double time, double p, double y2) {
  const Marginal marginal{.edges = {0, 1, 2}, .density = {p, 1 - p}, .lower = {}, .upper = {}};
  return {.time = time, .moments = {.y2 = y2}, .y = marginal, .ydot = marginal};
}

TEST(TransientRequest, EndsExactlyAtTheEndTime) {
  const TransientRequest request{.until = 0.7, .snapshots = 3};
  EXPECT_EQ(request.time_of_snapshot(0), 0);
  EXPECT_EQ(request.time_of_snapshot(3), 0.7);
  EXPECT_NEAR(request.time_of_snapshot(2), 0.7 * 2 / 3, 1e-15);
}

// The differences of E[y^2] are 0, 1, 0, 0, 2 at the times 0, 1, 2, 3, 4.
TEST(ErrorsByDifferences, AreTheLargestWithinHalfAPeriod) {
  std::vector<TransientDensitySnapshot> snapshots, coarse;
  const double differences[] = {0, 1, 0, 0, -2};
  for (int k = 0; k < 5; ++k) {
    snapshots.push_back(snapshot(k, 0.5, 3));
    coarse.push_back(snapshot(k, 0.5 + 0.1 * differences[k], 3 + differences[k]));
  }
  coarse.pop_back();
  estimate_errors_by_differences(coarse, 0.1, snapshots);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(snapshots[k].error->moments.y2, 1) << k;
  EXPECT_EQ(snapshots[3].error->moments.y2, 0);
  EXPECT_FALSE(snapshots[4].error);

  coarse.push_back(snapshot(4, 0.3, 1));
  estimate_errors_by_differences(coarse, 2, snapshots);
  EXPECT_EQ(snapshots[0].error->moments.y2, 1);
  EXPECT_EQ(snapshots[2].error->moments.y2, 2);
  // |p - q| differs by 0.2 in each of the two bins.
  EXPECT_NEAR(snapshots[4].error->y_l1, 0.4, 1e-12);
  EXPECT_NEAR(snapshots[4].error->ydot_l1, 0.4, 1e-12);
  EXPECT_EQ(snapshots[4].error->moments.v2, 0);
}

}  // namespace
}  // namespace fpkcheck::transform
