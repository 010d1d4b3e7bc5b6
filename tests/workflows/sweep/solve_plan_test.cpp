#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>
#include <string>

#include "made_up_sweep.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/execution/point_queue.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"

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

namespace {

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(JournaledQueue, ReportsThePointsOfAResumedSweep) {
  const tests::TemporaryDirectory directory;
  const Plan plan = tests::small_plan();
  const auto file = directory.path() / "journal";
  {
    JournaledQueue fresh(plan, directory.path(), {}, {});
    EXPECT_EQ(fresh.resumption_text(), "");
    for (const std::size_t point : {4, 0}) fresh.store({tests::result_of(plan, point), {}});
  }
  {
    const JournaledQueue again(plan, directory.path(), {}, {});
    const std::string text = again.resumption_text();
    EXPECT_TRUE(says(text, "2 of 6 points kept, 4 to solve")) << text;
    EXPECT_FALSE(says(text, "damaged")) << text;
  }
  // A killed process leaves the last line incomplete.
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 9);
  const std::string text = JournaledQueue(plan, directory.path(), {}, {}).resumption_text();
  EXPECT_TRUE(says(text, "1 of 6 points kept, 5 to solve")) << text;
  EXPECT_TRUE(says(text, "1 damaged line")) << text;
}

// A shard counts its own points alone.
TEST(JournaledQueue, OfAShardCountsItsPoints) {
  const tests::TemporaryDirectory directory;
  const Plan plan = tests::small_plan();
  Journal(directory.path() / "journal.2-of-3", plan).append(tests::result_of(plan, 1));
  const std::string text = JournaledQueue(plan, directory.path(), {2, 3}, {}).resumption_text();
  EXPECT_TRUE(says(text, "journal.2-of-3: 1 of 2 points kept, 1 to solve")) << text;
}

}  // namespace

}  // namespace fpkcheck::sweep
