#include "compare/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "compare/run_directory.hpp"
#include "compare/table.hpp"
#include "problem/input_error.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;
using tests::gnuplot_exists;
using tests::made_up_run;

std::string refusal(const fs::path& directory) {
  try {
    report_again(directory);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& file : fs::directory_iterator(directory.path() / "figures")) {
    ++files;
  }
  EXPECT_EQ(files, 6u);  // the densities and the error budget
}

TEST(Report, TheSamePageIsMadeAgain) {
  const tests::TemporaryDirectory directory;
  write_report(directory.path(), made_up_run());
  const fs::path page = directory.path() / "report.html";
  const std::string first = contents(page);
  EXPECT_TRUE(first.starts_with("<!doctype html>"));
  fs::remove(page);
  report_again(directory.path());
  EXPECT_EQ(contents(page), first);
}

TEST(Report, AgainIsTheSameReport) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  write_report(directory.path(), run);
  const SavedRun loaded = load_run(directory.path());
  EXPECT_EQ(loaded.summary, run.summary);
  EXPECT_EQ(loaded.marginals, run.marginals);
  const std::string script = contents(directory.path() / "figures" / "case1.gp");
  fs::remove_all(directory.path() / "figures");
  EXPECT_EQ(report_again(directory.path(), 80).table, table(run.summary, 80));
  EXPECT_EQ(contents(directory.path() / "figures" / "case1.gp"), script);
}

std::map<std::string, std::string> files_of(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) files[entry.path().string()] = contents(entry.path());
  }
  return files;
}

TEST(Report, ThatCannotBeWrittenLeavesTheEarlierRunWholeAndNothingHalf) {
  const tests::TemporaryDirectory directory;
  write_report(directory.path(), made_up_run("earlier"));
  const auto before = files_of(directory.path());
  SavedRun damaged = made_up_run("later");
  // The page, which is made last, needs them.
  damaged.summary["cases"][0].erase("solutions");
  damaged.joints.clear();
  EXPECT_ANY_THROW(write_report(directory.path(), damaged));
  EXPECT_TRUE(files_of(directory.path()) == before);

  // The page's place is taken: known only when the files are renamed.
  fs::remove(directory.path() / "report.html");
  fs::create_directories(directory.path() / "report.html" / "inside");
  auto without_page = before;
  without_page.erase((directory.path() / "report.html").string());
  EXPECT_THROW(write_report(directory.path(), made_up_run("later")), std::runtime_error);
  EXPECT_TRUE(files_of(directory.path()) == without_page);
}

TEST(Report, OfADamagedSummaryIsRefusedAndNothingIsWritten) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = made_up_run();
  write_report(directory.path(), run);
  write_file(directory.path() / "report.html", "as it was");
  const auto damaged = [&](const auto& damage) {
    auto summary = run.summary;
    damage(summary["cases"][0]);
    write_file(directory.path() / "summary.json", json_text(summary));
    const std::string message = refusal(directory.path());
    EXPECT_EQ(contents(directory.path() / "report.html"), "as it was") << message;
    EXPECT_FALSE(contains(message, "json.exception")) << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
    return message;
  };
  EXPECT_TRUE(contains(damaged([](auto& one) { one["budget"] = 3; }), "not a whole summary"));
  EXPECT_TRUE(contains(damaged([](auto& one) { one["solutions"][0].erase("moments"); }),
                       "not a whole summary (key 'moments' not found; run again)"));
  // Older runs have none.
  auto older = run.summary;
  older["cases"][0].erase("budget");
  older["cases"][0].erase("limits");
  write_file(directory.path() / "summary.json", json_text(older));
  EXPECT_EQ(refusal(directory.path()), "accepted");
}

TEST(Report, OfADirectoryWithoutARunIsRefusedInOneLine) {
  const tests::TemporaryDirectory directory;
  EXPECT_TRUE(contains(refusal(directory.path()), "no run in"));
  EXPECT_TRUE(contains(refusal(directory.path() / "absent"), "no run in"));
  const fs::path summary = directory.path() / "summary.json";
  write_file(summary, "{\"schema\": 1, ");
  EXPECT_TRUE(contains(refusal(directory.path()), "is not JSON"));
  write_file(summary, "[1]");
  EXPECT_TRUE(contains(refusal(directory.path()), "not the summary of a run"));
  write_file(summary, "{\"schema\": 2}");
  EXPECT_TRUE(contains(refusal(directory.path()), "has schema 2 (this program reads schema 1"));
  write_file(summary, "{\"schema\": 1}");
  EXPECT_TRUE(contains(refusal(directory.path()), "marginals.csv is not a readable file"));
  write_file(directory.path() / "marginals.csv",
             "case,solution,variable,abscissa,density,lower,upper\n");
  const std::string message = refusal(directory.path());
  EXPECT_TRUE(contains(message, "not a whole summary")) << message;
  EXPECT_FALSE(contains(message, "\n")) << message;
}

}  // namespace
}  // namespace fpkcheck::compare
