#include "results/saved_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "refusal.hpp"
#include "results/run_json.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;
using tests::contains;

void save(const fs::path& directory, const results::Run& run) {
  base::FileTransaction files;
  add_run_files(files, directory, run);
  files.commit();
}

std::string refusal_to_load(const fs::path& directory) {
  return tests::refusal([&] { load_run(directory); });
}

TEST(SavedRun, IsReadBackWhole) {
  const tests::TemporaryDirectory directory;
  const results::Run run = tests::made_up_run();
  save(directory.path(), run);
  const results::Run read = load_run(directory.path());
  EXPECT_EQ(run_summary_text(read), run_summary_text(run));
  EXPECT_EQ(read.cases[0].curves, run.cases[0].curves);
  ASSERT_EQ(read.cases[0].joints.size(), run.cases[0].joints.size());
  EXPECT_EQ(read.cases[0].joints[2].solution, run.cases[0].joints[2].solution);
}

TEST(SavedRun, WithSmoothBinsAndErrorEstimatesIsReadBackWhole) {
  const tests::TemporaryDirectory directory;
  results::Run run{results::current_program("fpkcheck run"),
                   {tests::made_up_case_with_control_variates()}};
  auto& one = run.cases[0];
  one.moment_error_estimates = {{"fd-kf", {.y2 = 0.5, .v4 = 2}, {.y1 = 1e-7, .v2 = -1e-6}}};
  save(directory.path(), run);
  const results::Run read = load_run(directory.path());
  EXPECT_EQ(run_summary_text(read), run_summary_text(run));
  EXPECT_EQ(read.cases[0].smooth, one.smooth);
  EXPECT_EQ(read.cases[0].pairs.back().l1_standard_error, one.pairs.back().l1_standard_error);
  EXPECT_EQ(read.cases[0].solutions.back().smooth_sampling->ydot_99, 6e-6);
  EXPECT_EQ(read.cases[0].moment_error_estimates[0].error.v2, -1e-6);
  // Saving a run without them removes those of an earlier run.
  save(directory.path(), tests::made_up_run());
  EXPECT_FALSE(fs::exists(directory.path() / kSmoothMarginalsFile));
}

TEST(SavedRun, OfAnOlderVersionHasNoJointDensities) {
  const tests::TemporaryDirectory directory;
  save(directory.path(), tests::made_up_run());
  fs::remove(directory.path() / kJointFile);
  EXPECT_TRUE(load_run(directory.path()).cases[0].joints.empty());
}

TEST(SavedRun, WithoutJointDensitiesRemovesEarlierOnes) {
  const tests::TemporaryDirectory directory;
  results::Run run = tests::made_up_run();
  save(directory.path(), run);
  run.cases[0].joints.clear();
  save(directory.path(), run);
  EXPECT_FALSE(fs::exists(directory.path() / kJointFile));
}

TEST(SavedRun, WithFilesOfSeveralRunsIsRefused) {
  const tests::TemporaryDirectory one, other;
  save(one.path(), tests::made_up_run("case1"));
  save(other.path(), tests::made_up_run("case2"));
  for (const char* file : {kMarginalsFile, kJointFile}) {
    fs::copy_file(one.path() / file, one.path() / "kept");
    fs::copy_file(other.path() / file, one.path() / file, fs::copy_options::overwrite_existing);
    EXPECT_TRUE(contains(refusal_to_load(one.path()), "are not of the same run")) << file;
    fs::rename(one.path() / "kept", one.path() / file);
  }
  results::Run fewer = tests::made_up_run("case1");
  std::erase_if(fewer.cases[0].curves, [](const DensityCurve& c) { return c.solution == "fd-kf"; });
  save(one.path(), fewer);
  EXPECT_TRUE(contains(refusal_to_load(one.path()), "are not of the same run"));
}

// Files that differ from those of the run only in their numbers.
TEST(SavedRun, WithAModifiedFileIsRefused) {
  const tests::TemporaryDirectory directory;
  save(directory.path(), tests::made_up_run("case1"));
  const fs::path file = directory.path() / kMarginalsFile;
  const std::string text = tests::contents(file);
  const auto digit = text.find_last_of("12345678");
  std::string changed = text;
  ++changed[digit];
  base::write_file_atomically(file, changed);
  EXPECT_TRUE(contains(refusal_to_load(directory.path()), "are not of the same run"));
  // Line ends may differ.
  std::string other_ends;
  for (const char c : text) other_ends += c == '\n' ? std::string("\r\n") : std::string(1, c);
  base::write_file_atomically(file, other_ends);
  EXPECT_EQ(refusal_to_load(directory.path()), "accepted");
}

TEST(SavedRun, WithInfiniteDensitiesOfFailedSolutionsIsReadBack) {
  const tests::TemporaryDirectory directory;
  results::Run run = tests::made_up_run();
  auto& solution = run.cases[0].solutions.back();
  const auto curve = std::ranges::find(run.cases[0].curves, solution.id(), &DensityCurve::solution);
  curve->density.front() = std::numeric_limits<double>::infinity();
  solution.status = transform::Status::failed;
  save(directory.path(), run);
  EXPECT_EQ(refusal_to_load(directory.path()), "accepted");
  solution.status = transform::Status::ok;
  save(directory.path(), run);
  EXPECT_TRUE(contains(refusal_to_load(directory.path()), "inf (numbers must be finite)"));
}

TEST(SavedRun, ThatDoesNotExistIsRefused) {
  const tests::TemporaryDirectory directory;
  EXPECT_TRUE(contains(refusal_to_load(directory.path()), "summary.json is not a readable file"));
  EXPECT_THROW(load_run_summary("nowhere.json"), InputError);
}

}  // namespace
}  // namespace fpkcheck::results
