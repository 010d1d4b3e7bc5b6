#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/execution/sweep_shards.hpp"
#include "workflows/sweep/result/journal.hpp"

namespace fpkcheck::sweep {
namespace {

TEST(Shard, EveryPointIsInOne) {
  std::multiset<std::size_t> all;
  for (std::size_t i = 1; i <= 4; ++i) {
    for (const auto point : SweepShard{i, 4}.shard_point_numbers(10)) all.insert(point);
  }
  EXPECT_EQ(all, (std::multiset<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ((SweepShard{2, 4}.shard_point_numbers(10)), (std::vector<std::size_t>{1, 5, 9}));
}

TEST(Shard, IsReadFromTheNameOfItsJournal) {
  const auto shard = shard_of_journal("journal.3-of-16");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->number, 3u);
  EXPECT_EQ(shard->of, 16u);
  ASSERT_TRUE(shard_of_journal("journal"));
  EXPECT_EQ(shard_of_journal("journal")->of, 1u);
  for (const char* bad : {"", "journal.", "journal.old", "journal.3-of-2", "journal.1-of-2x"}) {
    EXPECT_FALSE(shard_of_journal(bad)) << bad;
  }
}

TEST(Shard, HoldsItsPoints) {
  for (std::size_t i = 1; i <= 4; ++i) {
    for (const auto point : SweepShard{i, 4}.shard_point_numbers(10)) {
      EXPECT_EQ(SweepShard::shard_containing_point(point, 4).number, i);
    }
  }
}

TEST(Shard, IsReadFromITheSlashAndN) {
  EXPECT_EQ(parse_shard("3/16").shard_journal_name(), "journal.3-of-16");
  EXPECT_EQ(SweepShard{}.shard_journal_name(), "journal");
  for (const char* bad : {"", "3", "0/4", "5/4", "1/", "/4", "1/4x", "-1/4", "1.5/4"}) {
    EXPECT_THROW(parse_shard(bad), InputError) << bad;
  }
}

void write_shard(const SweepPlan& plan, const std::filesystem::path& directory,
                 const SweepShard& shard) {
  std::filesystem::create_directories(directory);
  SweepJournal journal(directory / shard.shard_journal_name(), plan);
  for (const auto point : shard.shard_point_numbers(plan.points.size())) {
    journal.append(tests::result_of(plan, point));
  }
}

TEST(MergedSweep, JoinsShards) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  write_shard(plan, directory.path() / "a", {1, 3});
  write_shard(plan, directory.path() / "a", {2, 3});
  write_shard(plan, directory.path() / "b", {3, 3});
  const auto all = merge_sweep_journals({directory.path() / "b", directory.path() / "a"},
                                        methods::builtin_registry());
  EXPECT_TRUE(all.results.is_complete());
  EXPECT_TRUE(all.remarks.empty());
  EXPECT_EQ(sweep_csv_text(all.results), sweep_csv_text(tests::results_of(plan)));
}

std::string remark_without(const std::vector<SweepShard>& missing, std::size_t of) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  for (std::size_t number = 1; number <= of; ++number) {
    if (std::ranges::find(missing, number, &SweepShard::number) != missing.end()) continue;
    write_shard(plan, directory.path(), {number, of});
  }
  const auto all = merge_sweep_journals({directory.path()}, methods::builtin_registry());
  EXPECT_FALSE(all.results.is_complete());
  EXPECT_EQ(all.remarks.size(), 1);
  return all.remarks.empty() ? "" : all.remarks[0];
}

TEST(MergedSweep, ReportsShardsWithMissingPoints) {
  const std::string one = remark_without({{2, 3}}, 3);
  EXPECT_NE(one.find("2 of 6 points"), std::string::npos) << one;
  EXPECT_NE(one.find("--shard 2/3 (2 points)"), std::string::npos) << one;
  EXPECT_EQ(one.find("1/3"), std::string::npos) << one;
  const std::string two = remark_without({{1, 4}, {3, 4}}, 4);
  EXPECT_NE(two.find("--shard 1/4 (2 points), 3/4 (1 point)"), std::string::npos) << two;
}

TEST(MergedSweep, ReportsAnIncompleteShard) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  write_shard(plan, directory.path(), {1, 2});
  SweepJournal(directory.path() / SweepShard{2, 2}.shard_journal_name(), plan)
      .append(tests::result_of(plan, 1));
  const auto all = merge_sweep_journals({directory.path()}, methods::builtin_registry());
  ASSERT_EQ(all.remarks.size(), 1);
  EXPECT_NE(all.remarks[0].find("--shard 2/2 (2 points)"), std::string::npos) << all.remarks[0];
}

TEST(MergedSweep, WithoutShardsSuggestsToRepeatTheSweep) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  SweepJournal(directory.path() / "journal", plan).append(tests::result_of(plan, 1));
  const auto all = merge_sweep_journals({directory.path()}, methods::builtin_registry());
  ASSERT_EQ(all.remarks.size(), 1);
  EXPECT_EQ(all.remarks[0].find("--shard"), std::string::npos) << all.remarks[0];
}

TEST(MergedSweep, OtherPlansAndEmptyDirectoriesAreRefused) {
  const tests::TemporaryDirectory directory;
  write_shard(tests::small_plan(), directory.path(), {1, 2});
  write_shard(tests::plan_of({parse_sweep_axis("impulse.rate", "1,2", "x")}), directory.path(),
              {2, 2});
  EXPECT_THROW(merge_sweep_journals({directory.path()}, methods::builtin_registry()), InputError);
  const tests::TemporaryDirectory empty;
  EXPECT_THROW(merge_sweep_journals({empty.path()}, methods::builtin_registry()), InputError);
  EXPECT_THROW(merge_sweep_journals({empty.path() / "absent"}, methods::builtin_registry()),
               InputError);
}

}  // namespace
}  // namespace fpkcheck::sweep
