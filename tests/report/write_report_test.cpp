#include "report/write_report.hpp"

#include <gtest/gtest.h>

#include <map>

#include "report/terminal_tables.hpp"
#include "results/output_directory.hpp"
#include "results/saved_run.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;
using tests::contents;
using tests::gnuplot_exists;
using tests::made_up_run;

std::map<std::string, std::string> files_of(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) files[entry.path().string()] = contents(entry.path());
  }
  return files;
}

TEST(Report, LeavesASummaryTheCurvesAndPicturesAndNothingHalf) {
  const tests::TemporaryDirectory directory;
  const auto warnings = write_report(directory.path(), made_up_run());
  EXPECT_EQ(directory.entries().size(), 5u);
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "summary.json"));
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "marginals.csv"));
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "joint.nc"));
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "report.html"));
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "figures" / "case1.gp"));
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_EQ(
      std::distance(fs::directory_iterator(directory.path() / "figures"), {}),
      6);  // a PNG and a script each for the densities, the error budget and the orders of closures
}

TEST(Report, AgainIsTheSameReport) {
  const tests::TemporaryDirectory directory;
  const auto run = made_up_run();
  write_report(directory.path(), run);
  const auto before = files_of(directory.path());
  fs::remove_all(directory.path() / "figures");
  fs::remove(directory.path() / "report.html");
  const auto again = rebuild_report(directory.path(), results::load_run(directory.path()), 80);
  EXPECT_EQ(again.text, terminal_tables_text(run, 80));
  for (const auto& [file, text] : files_of(directory.path())) {
    EXPECT_TRUE(before.contains(file) && before.at(file) == text) << file;
  }
  EXPECT_EQ(files_of(directory.path()).size(), before.size());
}

TEST(Report, OfAnotherRunLeavesNothingOfTheEarlierOne) {
  const tests::TemporaryDirectory directory;
  write_report(directory.path(), made_up_run("earlier"));
  write_report(directory.path(), made_up_run("later"));
  for (const auto& [file, text] : files_of(directory.path() / "figures")) {
    EXPECT_TRUE(fs::path(file).filename().string().starts_with("later")) << file;
  }
  EXPECT_FALSE(files_of(directory.path() / "figures").empty());
}

TEST(Report, ThatCannotBeWrittenLeavesTheEarlierRunWholeAndNothingHalf) {
  const tests::TemporaryDirectory directory;
  write_report(directory.path(), made_up_run("earlier"));
  const auto before = files_of(directory.path());
  auto damaged = made_up_run("later");
  // Two metrics with the same path fail when the summary is made, after the curves.
  damaged.cases[0].solutions[0].metrics.assign(2, {.path = "same", .value = 1.0});
  EXPECT_THROW(write_report(directory.path(), damaged), std::logic_error);
  EXPECT_TRUE(files_of(directory.path()) == before);

  // A directory with the name of the page makes the renaming of the files fail.
  fs::remove(directory.path() / "report.html");
  fs::create_directories(directory.path() / "report.html" / "inside");
  auto without_page = before;
  without_page.erase((directory.path() / "report.html").string());
  EXPECT_THROW(write_report(directory.path(), made_up_run("later")), std::runtime_error);
  EXPECT_TRUE(files_of(directory.path()) == without_page);
}

// Missing metrics and distances appear as dashes and cause no crash.
TEST(Report, OfAnOlderRunWithoutBudgetIdentityOrJointDensitiesIsMade) {
  const tests::TemporaryDirectory directory;
  auto run = made_up_run();
  auto& case_result = run.cases[0];
  case_result.budget.clear();
  case_result.joints.clear();
  for (auto& solution : case_result.solutions) {
    auto& identity = solution.identity;
    identity = {.id = identity.id,
                .method = identity.method,
                .equation = identity.equation,
                .impact = identity.impact};
  }
  case_result.update_assessment();
  const auto again = rebuild_report(directory.path(), run);
  EXPECT_TRUE(tests::contains(again.text, "There is no reference")) << again.text;
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "report.html"));
  EXPECT_TRUE(fs::is_regular_file(directory.path() / "figures" / "case1.gp"));
  EXPECT_FALSE(fs::exists(directory.path() / "figures" / "case1-budget.gp"));
}

}  // namespace
}  // namespace fpkcheck::report
