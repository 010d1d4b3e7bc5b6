#include "cli/help.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/program.hpp"
#include "methods/builtin_solvers.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::cli {
namespace {

using Words = std::vector<std::string>;

std::string printed(const Words& arguments) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_program(arguments), kSuccess);
  std::fflush(stdout);
  return testing::internal::GetCapturedStdout();
}

Words completed(Words words) {
  words.insert(words.begin(), "--complete");
  std::istringstream lines(printed(words));
  Words result;
  for (std::string line; std::getline(lines, line);) result.push_back(line);
  return result;
}

bool has(const Words& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

TEST(Completion, OffersAllCommandsAndTheirOptions) {
  const auto commands = completed({""});
  const auto registry = methods::builtin_registry();
  for (const auto& solver : registry.solvers()) {
    EXPECT_TRUE(has(commands, solver.name)) << solver.name;
    const auto options = completed({solver.name, "case1", "--"});
    for (const auto& parameter : solver.option_descriptions->parameters()) {
      if (parameter.flag.empty()) continue;
      EXPECT_TRUE(has(options, "--" + parameter.flag)) << solver.name << ' ' << parameter.flag;
      if (parameter.choices.empty()) continue;
      EXPECT_EQ(completed({solver.name, "--" + parameter.flag, ""}), parameter.choices);
    }
  }
  for (const auto& command : commands) {
    if (command.starts_with("--")) continue;
    const bool has_subjects = command == "study" || command == "help";
    EXPECT_EQ(has(completed({command, "--"}), "--help"), !has_subjects) << command;
  }
}

TEST(Completion, OffersSubjectsAlsoAfterHelp) {
  EXPECT_EQ(completed({"study", ""}), (Words{"grid", "order", "regularisation"}));
  EXPECT_TRUE(has(completed({"study", "grid", "--"}), "--orders"));
  EXPECT_EQ(completed({"help", "study", "g"}), Words{"grid"});
  EXPECT_EQ(completed({"help", "rep"}), Words{"report"});
}

TEST(Completion, OffersCasesMethodsAndKeys) {
  const auto cases = completed({"run", ""});
  for (const auto& named : problem::paper_cases()) EXPECT_TRUE(has(cases, named.name));
  EXPECT_TRUE(has(cases, kFileNamesCandidate));
  EXPECT_EQ(completed({"report", ""}), Words{kDirectoryNamesCandidate});
  EXPECT_EQ(completed({"check", ""}), Words{kFileNamesCandidate});
  EXPECT_EQ(completed({"run", "--out", ""}), Words{kDirectoryNamesCandidate});
  EXPECT_TRUE(has(completed({"run", "--methods", "fd-"}), "fd-kf"));
  EXPECT_EQ(completed({"run", "--methods", "mcs,epc-polar-n4,fd-w"}),
            Words{"mcs,epc-polar-n4,fd-white"});
  EXPECT_EQ(completed({"run", "--set", "system.res"}), Words{"system.restitution="});
  EXPECT_EQ(completed({"run", "hertz", "--set", "param"}),
            (Words{"parameters.c=", "parameters.k="}));
}

TEST(Completion, IsEmptyWithoutCandidates) {
  EXPECT_EQ(completed({"cook", "--"}), Words{});
  EXPECT_EQ(completed({"fd", "--nx", ""}), Words{});
  EXPECT_EQ(completed({}), Words{});
}

TEST(Manual, HasEveryCommandWithItsOptions) {
  const auto page = printed({"--manual"});
  EXPECT_TRUE(page.starts_with(".TH FPKCHECK 1"));
  for (const auto* expected :
       {".SS fpkcheck run\n", ".SS fpkcheck study grid\n", ".SS fpkcheck report\n",
        "\\fB\\-\\-origin\\-refinement\\fR \\fIF\\fR", "\\fB\\-q\\fR, \\fB\\-\\-quiet\\fR"}) {
    EXPECT_NE(page.find(expected), std::string::npos) << expected;
  }
}

}  // namespace
}  // namespace fpkcheck::cli
