#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "methods/builtin_solvers.hpp"
#include "temporary_directory.hpp"

/// Output that a command adds to a run (Supplement), as `paper` does.
namespace fpkcheck::cli {
namespace {

namespace fs = std::filesystem;

struct SimulationRunOutcome {
  int exit_code;
  std::string out, err;
};

SimulationRunOutcome solve(const CommonCommandArguments& common, const RunSupplement& supplement) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = solve_and_report(common,
                                         methods::builtin_registry().methods_selected_by_list(
                                             "epc-gaussian-n2", {{"accuracy", base::Value()}}),
                                         {.supplement =
                                              [&](const results::Run& run) {
                                                EXPECT_EQ(run.cases.size(), 1u);
                                                return supplement;
                                              }},
                                         "fpkcheck paper");
  std::fflush(stdout);
  return {exit_code, testing::internal::GetCapturedStdout(),
          testing::internal::GetCapturedStderr()};
}

TEST(RunSupplement, IsPrintedAfterTheTableAndWrittenToFiles) {
  const tests::TemporaryDirectory directory;
  CommonCommandArguments common;
  common.cases = {"case1"};
  common.out = directory.path().string();
  const auto outcome = solve(common, {.report = {.summary = {"First of all."},
                                                 .text = "\nand more\n",
                                                 .sections = {},
                                                 .files = {{"more.csv", "a,b\n"}},
                                                 .pictures = {{"more", "# nothing to draw\n"}}},
                                      .json = {},
                                      .failures = {}});
  EXPECT_EQ(outcome.exit_code, kSuccess);
  EXPECT_TRUE(outcome.out.starts_with("First of all.\n\n")) << outcome.out;
  EXPECT_LT(outcome.out.find("epc-gaussian-n2"), outcome.out.find("\nand more\n"));
  EXPECT_NE(outcome.out.find(", more.csv and "), std::string::npos) << outcome.out;
  std::ifstream written(directory.path() / "more.csv");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "a,b\n");
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "more.gp"));
  // A script that draws nothing causes a warning.
  EXPECT_NE(outcome.err.find("more.png"), std::string::npos) << outcome.err;
}

TEST(RunSupplement, ReplacesTheSummaryAndSetsTheExitCode) {
  CommonCommandArguments common;
  common.cases = {"case1"};
  common.json = true;
  RunSupplement supplement{.report = {}, .json = "{}", .failures = {"why"}};
  supplement.report.text = "not this";
  const auto json = solve(common, supplement);
  EXPECT_EQ(json.exit_code, kFailure);
  EXPECT_EQ(json.out, "{}\n");
  common.json = false;
  common.quiet = true;
  const auto quiet = solve(common, supplement);
  EXPECT_EQ(quiet.out, "");
  EXPECT_NE(quiet.err.find("why"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::cli
