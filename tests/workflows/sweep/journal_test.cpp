#include "workflows/sweep/result/journal.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {
namespace {

class JournalFile : public testing::Test {
 protected:
  JournalFile() {
    SweepJournal journal(file_, plan_);
    EXPECT_TRUE(journal.initial_journal_content().points.empty());
    for (const std::size_t point : {4, 0, 2}) journal.append(tests::result_of(plan_, point));
  }

  void rewrite(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }
  std::string text() const { return tests::contents(file_); }

  const SweepPlan plan_ = tests::small_plan();
  tests::TemporaryDirectory directory_;
  const std::filesystem::path file_ = directory_.path() / "journal";
};

TEST_F(JournalFile, ResumesWithTheStoredPoints) {
  {
    SweepJournal again(file_, plan_);
    EXPECT_EQ(again.initial_journal_content().damaged, 0);
    ASSERT_EQ(again.initial_journal_content().points.size(), 3);
    again.append(tests::result_of(plan_, 5));
  }
  const auto content = read_sweep_journal(file_);
  EXPECT_EQ(sweep_csv_text(make_sweep_results(plan_, content.points)),
            sweep_csv_text(make_sweep_results(
                plan_, {tests::result_of(plan_, 0), tests::result_of(plan_, 2),
                        tests::result_of(plan_, 4), tests::result_of(plan_, 5)})));
}

// A process may be killed at any byte of a line.
TEST_F(JournalFile, TruncatedLosesItsLastPointAtMost) {
  const std::string whole = text();
  const auto last = whole.rfind('\n', whole.size() - 2) + 1;
  for (auto length = last + 1; length < whole.size(); length += 7) {
    rewrite(whole.substr(0, length));
    SweepJournal journal(file_, plan_);
    EXPECT_EQ(journal.initial_journal_content().points.size(), 2);
    EXPECT_EQ(journal.initial_journal_content().damaged, 1);
    journal.append(tests::result_of(plan_, 2));
    EXPECT_EQ(text(), whole);
  }
  // Cut in the first line: as a new journal.
  rewrite(whole.substr(0, 100));
  EXPECT_TRUE(SweepJournal(file_, plan_).initial_journal_content().points.empty());
}

TEST_F(JournalFile, IgnoresDamagedLines) {
  std::string damaged = text();
  damaged[damaged.find("fd-kf", damaged.find('\n')) + 1] = 'x';
  rewrite(damaged);
  SweepJournal journal(file_, plan_);
  EXPECT_EQ(journal.initial_journal_content().points.size(), 2);
  EXPECT_EQ(journal.initial_journal_content().damaged, 1);
}

TEST_F(JournalFile, RefusesAnotherPlan) {
  const SweepPlan other = tests::plan_of({parse_sweep_axis("impulse.rate", "1,2", "x")});
  try {
    SweepJournal journal(file_, other);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("begun with another plan"), std::string::npos);
  }
}

TEST_F(JournalFile, IsWrittenByOneProcessAtATime) {
  const SweepJournal first(file_, plan_);
  EXPECT_THROW(SweepJournal(file_, plan_), InputError);
}

TEST_F(JournalFile, RefusesOtherFiles) {
  for (const char* content : {"hello\n", "12345678 {}\n", "\n", "00000000 {\"schema\":1}\n"}) {
    rewrite(content);
    EXPECT_THROW(SweepJournal(file_, plan_), InputError) << content;
    EXPECT_THROW(read_sweep_journal(file_), InputError) << content;
  }
  EXPECT_THROW(read_sweep_journal(directory_.path() / "absent"), InputError);
}

TEST_F(JournalFile, TheFirstOfTwoLinesOfAPointCounts) {
  {
    SweepJournal journal(file_, plan_);
    auto other = tests::result_of(plan_, 0);
    other.reference = "mcs";
    journal.append(other);
  }
  const auto content = read_sweep_journal(file_);
  ASSERT_EQ(content.points.size(), 3);
  EXPECT_EQ(content.points[1].reference, "fd-kf");
}

// NaN remains NaN, and reasons may contain any bytes.
TEST_F(JournalFile, KeepsNaNAndAnyReason) {
  auto odd = tests::result_of(plan_, 1);
  odd.methods[0].moments->y2 = std::numeric_limits<double>::quiet_NaN();
  odd.methods[0].status = transform::Status::failed;
  odd.methods[0].reason = "\"two\"\nlines \xff";
  odd.methods[1].moments.reset();
  SweepJournal(file_, plan_).append(odd);
  const auto points = read_sweep_journal(file_).points;
  EXPECT_TRUE(std::isnan(points.back().methods[0].moments->y2));
  EXPECT_EQ(points.back().methods[0].status, transform::Status::failed);
  EXPECT_TRUE(points.back().methods[0].reason.starts_with("\"two\"\\x0alines "))
      << points.back().methods[0].reason;
  EXPECT_FALSE(points.back().methods[1].moments);
}

}  // namespace
}  // namespace fpkcheck::sweep
