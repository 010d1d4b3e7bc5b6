#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "base/files/file_transaction.hpp"
#include "cli/program.hpp"
#include "methods/builtin_solvers.hpp"
#include "results/saved_run.hpp"
#include "temporary_directory.hpp"
#include "workflows/paper/claims.hpp"
#include "workflows/paper/claims_supplement.hpp"
#include "workflows/paper/claims_table.hpp"
#include "workflows/paper/judge_claims.hpp"
#include "workflows/paper/judged_run.hpp"

/// `report` for the directory of a run of `paper`.
namespace fpkcheck::cli {
namespace {

namespace fs = std::filesystem;

using tests::contents;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Writes the files of a run, without report.html and figures.
void save(const fs::path& directory, const results::Run& run) {
  base::FileTransaction files;
  results::add_run_files(files, directory, run);
  files.commit();
}

std::string report_of(const fs::path& directory) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_program({"report", directory.string()}, methods::builtin_registry()), kSuccess);
  std::fflush(stdout);
  return testing::internal::GetCapturedStdout();
}

TEST(ReportOfPaper, HasTheSummaryFirstAndClaimsAndFiguresOnItsPage) {
  const tests::TemporaryDirectory directory;
  const auto run = tests::run_with_distances();
  save(directory.path(), run);
  const std::string text = report_of(directory.path());
  // The judgements are those of the saved run.
  const auto judgements = paper::judge_claims(run);
  EXPECT_EQ(text.find(fmt::format("{} claims", judgements.size())), 0u) << text.substr(0, 200);
  EXPECT_EQ(contents(directory.path() / paper::kClaimsCsv), paper::claims_csv(judgements));
  EXPECT_TRUE(fs::exists(directory.path() / paper::kClaimsJson));
  const std::string page = contents(directory.path() / "report.html");
  const auto begin = page.find("<section id=\"claims\">");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = page.substr(begin, page.find("</section>", begin) - begin);
  for (const auto& row : paper::claim_table_rows(judgements)) {
    EXPECT_NE(section.find(">" + row.outcome + "<"), std::string::npos) << row.outcome;
  }
  EXPECT_EQ(count(section, "<span class=\"chip "), judgements.size());
  for (const char* number : {"2", "3", "4", "5"}) {
    const std::string figure = std::string("paper-fig-") + number;
    EXPECT_TRUE(fs::exists(directory.path() / "figures" / (figure + ".gp"))) << figure;
    for (const char* variable : {"y", "ydot"}) {
      EXPECT_EQ(count(section, "id=\"" + figure + "-density-" + variable + "\""), 1u) << figure;
    }
  }
  EXPECT_LT(page.find("claims of the paper"), page.find("<section id=\"verdict\">"));
}

TEST(ReportOfPaper, IsOmittedForOtherRunsOfTheSameCases) {
  const tests::TemporaryDirectory directory;
  auto run = tests::run_with_distances();
  run.program.command = "fpkcheck run --out paper";
  save(directory.path(), run);
  EXPECT_EQ(report_of(directory.path()).find("claims"), std::string::npos);
  EXPECT_FALSE(fs::exists(directory.path() / paper::kClaimsCsv));
}

}  // namespace
}  // namespace fpkcheck::cli
