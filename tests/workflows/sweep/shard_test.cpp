#include "workflows/sweep/execution/shard.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/input_error.hpp"

namespace fpkcheck::sweep {
namespace {

TEST(Shard, EveryPointIsInOne) {
  std::multiset<std::size_t> all;
  for (std::size_t i = 1; i <= 4; ++i) {
    for (const auto point : Shard{i, 4}.points(10)) all.insert(point);
  }
  EXPECT_EQ(all, (std::multiset<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ((Shard{2, 4}.points(10)), (std::vector<std::size_t>{1, 5, 9}));
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
    for (const auto point : Shard{i, 4}.points(10)) {
      EXPECT_EQ(Shard::containing(point, 4).number, i);
    }
  }
}

TEST(Shard, IsReadFromITheSlashAndN) {
  EXPECT_EQ(parse_shard("3/16").journal_name(), "journal.3-of-16");
  EXPECT_EQ(Shard{}.journal_name(), "journal");
  for (const char* bad : {"", "3", "0/4", "5/4", "1/", "/4", "1/4x", "-1/4", "1.5/4"}) {
    EXPECT_THROW(parse_shard(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace fpkcheck::sweep
