#include "workflows/study/transient/report.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "made_up_transient.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::study {
namespace {

namespace fs = std::filesystem;
using tests::contains;

TEST(TransientReport, WithoutGnuplotWarnsAndWritesTheScript) {
  const tests::TemporaryDirectory directory;
  const auto warnings =
      write_transient(directory.path(), tests::made_up_transient(), {}, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "'no-such-gnuplot' was not found")) << warnings.front();
  EXPECT_TRUE(fs::exists(directory.path() / "transient.nc"));
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "transient-it_s_a__case_.gp"));
}

TEST(TransientReport, AFileThatCannotBeWrittenIsUnchanged) {
  const tests::TemporaryDirectory directory;
  fs::create_directories(directory.path() / "transient.nc" / "occupied");
  EXPECT_THROW(write_transient(directory.path(), tests::made_up_transient()), std::runtime_error);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"transient.nc"});
}

TEST(TransientReport, RemovesFilesOfAnEarlierRunWithoutADensity) {
  const tests::TemporaryDirectory directory;
  TransientRun run = tests::made_up_transient();
  write_transient(directory.path(), run);
  run.result.snapshots.clear();
  EXPECT_EQ(write_transient(directory.path(), run).size(), 1u);
  EXPECT_FALSE(fs::exists(directory.path() / "transient.nc"));
  EXPECT_TRUE(fs::is_empty(directory.path() / "figures"));
}

TEST(TransientReport, TableFitsEightyColumnsAndIsThinnedEvenly) {
  for (const int last : {1, 4, 24, 25, 1000}) {
    TransientRun run = tests::made_up_transient(last);
    run.result.status = transform::Status::inadmissible;
    run.result.reason = "at t = 1 the density is negative";
    run.result.snapshots.back().moments.v1 = -123.4567;
    std::istringstream lines(transient_table(run, 80));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_LE(count, 24 + 10);
    EXPECT_TRUE(contains(transient_table(run, 80), "inadmissible: at t = 1"));
  }
}

}  // namespace
}  // namespace fpkcheck::study
