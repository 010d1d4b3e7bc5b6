#include "workflows/sweep/execution/point_queue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

std::vector<std::size_t> all_of(const Plan& plan) {
  std::vector<std::size_t> all(plan.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

TEST(PointQueue, AssignsEachPointOnceTheLongestFirst) {
  const Plan plan = tests::plan_of({parse_axis("impulse.rate", "log:0.1:10:200", "x")});
  PointQueue queue(plan, all_of(plan), {});
  const auto seconds = [&](std::size_t p) { return std::get<double>(plan.points[p][0]); };
  std::set<std::size_t> seen;
  std::vector<std::size_t> order;
  for (auto point = queue.take_next_point(); point; point = queue.take_next_point()) {
    EXPECT_TRUE(seen.insert(*point).second);
    order.push_back(*point);
    queue.record_solved(*point, seconds(*point));
  }
  EXPECT_EQ(seen.size(), 200);
  // After the initial sample the order is by time; the last points are short.
  for (std::size_t k = 30; k + 1 < order.size(); ++k) {
    EXPECT_GE(seconds(order[k]), 0.95 * seconds(order[k + 1]));
  }
  EXPECT_EQ(queue.state().done, 200);
  EXPECT_NEAR(*queue.state().remaining_seconds, 0, 1);
}

TEST(PointQueue, SkipsSolvedPoints) {
  const Plan plan = tests::small_plan();
  PointQueue queue(plan, {0, 2, 4}, {tests::result_of(plan, 2), tests::result_of(plan, 1)});
  std::set<std::size_t> seen;
  for (auto point = queue.take_next_point(); point; point = queue.take_next_point())
    seen.insert(*point);
  EXPECT_EQ(seen, (std::set<std::size_t>{0, 4}));
  EXPECT_EQ(queue.state().done, 1);
  EXPECT_EQ(queue.state().total, 3);
}

}  // namespace
}  // namespace fpkcheck::sweep
