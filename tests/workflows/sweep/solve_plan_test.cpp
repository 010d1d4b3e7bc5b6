#include "workflows/sweep/execution/solve_plan.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "made_up_sweep.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::sweep {
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
