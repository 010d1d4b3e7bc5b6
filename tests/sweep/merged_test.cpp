#include "sweep/execution/merged.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "made_up_sweep.hpp"
#include "parameters/input_error.hpp"
#include "sweep/execution/shard.hpp"
#include "sweep/result/journal.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::sweep {
namespace {

void write_shard(const Plan& plan, const std::filesystem::path& directory, const Shard& shard) {
  std::filesystem::create_directories(directory);
  Journal journal(directory / shard.journal_name(), plan);
  for (const auto point : shard.points(plan.points.size())) {
    journal.append(tests::result_of(plan, point));
  }
}

TEST(Merged, ShardsMakeTheWhole) {
  const tests::TemporaryDirectory directory;
  const Plan plan = tests::small_plan();
  write_shard(plan, directory.path() / "a", {1, 3});
  write_shard(plan, directory.path() / "a", {2, 3});
  write_shard(plan, directory.path() / "b", {3, 3});
  const auto all = merged({directory.path() / "b", directory.path() / "a"}, methods::builtin());
  EXPECT_TRUE(all.results.is_whole());
  EXPECT_TRUE(all.remarks.empty());
  EXPECT_EQ(csv(all.results), csv(tests::results_of(plan)));
}

TEST(Merged, WhatIsMissingIsSaid) {
  const tests::TemporaryDirectory directory;
  const Plan plan = tests::small_plan();
  write_shard(plan, directory.path(), {1, 2});
  const auto all = merged({directory.path()}, methods::builtin());
  EXPECT_FALSE(all.results.is_whole());
  ASSERT_EQ(all.remarks.size(), 1);
  EXPECT_NE(all.remarks[0].find("3 of 6 points are missing, the first is number 1"),
            std::string::npos);
}

TEST(Merged, OtherPlansAndEmptyDirectoriesAreRefused) {
  const tests::TemporaryDirectory directory;
  write_shard(tests::small_plan(), directory.path(), {1, 2});
  write_shard(tests::plan_of({axis_from("impulse.rate", "1,2", "x")}), directory.path(), {2, 2});
  EXPECT_THROW(merged({directory.path()}, methods::builtin()), InputError);
  const tests::TemporaryDirectory empty;
  EXPECT_THROW(merged({empty.path()}, methods::builtin()), InputError);
  EXPECT_THROW(merged({empty.path() / "absent"}, methods::builtin()), InputError);
}

}  // namespace
}  // namespace fpkcheck::sweep
