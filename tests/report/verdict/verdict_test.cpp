#include "report/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "../modified_case.hpp"
#include "report/findings.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::collapse_whitespace;
using tests::contains;
using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;

results::Run run_of(std::vector<results::CaseResult> cases) {
  return {results::current_program("fpkcheck run"), std::move(cases)};
}

std::string outcome_in(const RunVerdict& run_verdict, const std::string& subject) {
  for (const auto& line : run_verdict.lines) {
    if (line.subject == subject) return line.outcome;
  }
  return "";
}

std::string text_of_run(const results::Run& run) {
  return run_verdict_text(run, make_run_verdict(run), 100);
}

/// A case where n = 2 and white noise are distant, n = 4 is inadmissible, n = 6 close, n = 8 not
/// found.
results::CaseResult usual(const std::string& name) {
  auto case_result = made_up_case(name);
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.03, 0.004);
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.0024, 0.0047);
  set_l1(case_result, "fd-white", "mcs", 0.011, 0.031);
  set_l1(case_result, "fd-km4", "mcs", 0.002, 0.003);
  set_l1(case_result, "fd-kf", "mcs", 0.0012, 0.0016);
  return case_result;
}

TEST(Verdict, StatesTheReferenceAndItsReproduction) {
  const auto run_verdict = make_run_verdict(run_of({usual("a")}));
  const std::vector<std::string> expected{
      "The reference is mcs, with L1 error estimates of 0.001 in p(y) and 0.002 in p(y'). The L1 "
      "distance of the independent solution fd-kf to the reference is 0.0012 in p(y) and 0.0016 in "
      "p(y').",
      "Within L1 0.02 of the reference: epc-gaussian (the paper's closure) at n = 6, not at n = 2, "
      "4, 8."};
  EXPECT_EQ(run_verdict.answer, expected);
}

TEST(Verdict, HasALineForEachOrderOfThePapersClosure) {
  const auto run_verdict = make_run_verdict(run_of({usual("a")}));
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n2"),
            "not reproduced: L1 distance 0.03 in p(y) and 0.004 in p(y')");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n4"),
            "not reproduced: inadmissible: no probability density");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n6"),
            "reproduced: L1 distance 0.0024 in p(y) and 0.0047 in p(y')");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n8"),
            "not reproduced: not_converged: no solution found");
  EXPECT_EQ(outcome_in(run_verdict, "fd-white"),
            "not reproduced: L1 distance 0.011 in p(y) and 0.031 in p(y')");
  EXPECT_EQ(outcome_in(run_verdict, "fd-kf"),
            "");  // fd-kf solves the full problem: no approximation
}

TEST(Verdict, HasALineForAClosureWithoutAnOrder) {
  auto case_result = usual("a");
  auto& averaged = solution_of(case_result, "epc-gaussian-n2");
  averaged.identity.order = {};
  averaged.identity.formulation = "";
  averaged.identity.method = averaged.identity.family = "averaging";
  const auto run_verdict = make_run_verdict(run_of({case_result}));
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n2"),
            "not reproduced: L1 distance 0.03 in p(y) and 0.004 in p(y')");
  EXPECT_TRUE(contains(run_verdict.answer.back(), "not at n = 4, 8; not epc-gaussian-n2."));
}

TEST(Verdict, ListsAnExternalDensityByItself) {
  auto case_result = usual("a");
  auto& guest = solution_of(case_result, "epc-gaussian-n2");
  guest.identity.method = transform::kExternalFile;
  guest.identity.family = "file";
  const auto run_verdict = make_run_verdict(run_of({case_result}));
  EXPECT_EQ(
      run_verdict.answer[1],
      "Within L1 0.02 of the reference: epc-gaussian (the paper's closure) at n = 6, not at n "
      "= 4, 8; not epc-gaussian-n2.");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n2"),
            "not reproduced: L1 distance 0.03 in p(y) and 0.004 in p(y')");
}

TEST(Verdict, ListsAnExternalFamilyTogether) {
  auto case_result = usual("a");
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n6"}) {
    auto& guest = solution_of(case_result, id);
    guest.identity.method = transform::kExternalFile;
    guest.identity.family = "chi";
  }
  const auto run_verdict = make_run_verdict(run_of({case_result}));
  EXPECT_TRUE(run_verdict.answer[1].starts_with(
      "Within L1 0.02 of the reference: chi at n = 6, not at n = 2;"))
      << run_verdict.answer[1];
  EXPECT_TRUE(
      outcome_in(run_verdict, "chi").starts_with("reproduced in part: n = 2 has L1 distance 0.03"))
      << outcome_in(run_verdict, "chi");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n2"), "");
}

TEST(Verdict, OfSeveralCasesStatesTheWorstAndTheirNumber) {
  auto second = usual("b");
  set_l1(second, "epc-gaussian-n6", "mcs", 0.05, 0.001);
  set_l1(second, "fd-kf", "mcs", 0.004, 0.0001);
  const auto run_verdict = make_run_verdict(run_of({usual("a"), second, usual("c")}));
  EXPECT_TRUE(run_verdict.answer[0].starts_with("The reference in all 3 cases is mcs, "))
      << run_verdict.answer[0];
  EXPECT_TRUE(contains(run_verdict.answer[0], "0.004 in p(y) and 0.0016 in p(y')"))
      << run_verdict.answer[0];
  EXPECT_EQ(
      run_verdict.answer[1],
      "Within L1 0.02 of the reference in all 3 cases: none of epc-gaussian (the paper's closure) "
      "at n = 2, 4, 6, 8.");
  EXPECT_EQ(
      outcome_in(run_verdict, "epc-gaussian-n6"),
      "reproduced in part: L1 distance at most 0.0024 in p(y) and 0.0047 in p(y') in 2 of 3 cases; "
      "L1 distance up to 0.05 in p(y) and 0.001 in p(y') in 1 of 3 cases");
  EXPECT_EQ(outcome_in(run_verdict, "epc-gaussian-n4"),
            "not reproduced: inadmissible in all 3 cases: no probability density");
}

TEST(Verdict, NamesTheReferenceCaseByCaseWhereItDiffers) {
  auto second = usual("b");
  solution_of(second, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  second.update_assessment();
  const auto run_verdict = make_run_verdict(run_of({usual("a"), second, usual("c")}));
  EXPECT_TRUE(contains(run_verdict.answer[0], "is mcs (fd-kf in b), with"))
      << run_verdict.answer[0];
  EXPECT_TRUE(contains(run_verdict.answer[0], "independent solution fd-kf (mcs in b) to the"))
      << run_verdict.answer[0];
  EXPECT_TRUE(contains(run_verdict.recommendation[0], "; fd-kf (mcs in b) confirms these values."))
      << run_verdict.recommendation[0];
}

TEST(Verdict, RecommendsTheReferenceAndTheFastestSolution) {
  auto case_result = usual("a");
  for (auto& solution : case_result.solutions) solution.seconds = 5;
  solution_of(case_result, "epc-gaussian-n6").seconds = 0.5;
  solution_of(case_result, "epc-gaussian-n2").seconds = 0.1;  // fastest, but distant
  auto run_verdict = make_run_verdict(run_of({case_result}));
  ASSERT_EQ(run_verdict.recommendation.size(), 2u);
  EXPECT_TRUE(contains(run_verdict.recommendation[0], "use mcs, the solution"))
      << run_verdict.recommendation[0];
  EXPECT_TRUE(contains(run_verdict.recommendation[0], "fd-kf confirms these values"))
      << run_verdict.recommendation[0];
  EXPECT_EQ(run_verdict.recommendation[1],
            "Fastest solution with status ok: within L1 0.01, epc-gaussian-n6 (0.5 s).");
  // The error estimate of the reference is added to the distance: 0.0047 + 0.006.
  solution_of(case_result, "mcs").sampling = {.y = 0.006, .ydot = 0.006};
  case_result.update_assessment();
  run_verdict = make_run_verdict(run_of({case_result}));
  EXPECT_EQ(run_verdict.recommendation[1],
            "Fastest solution with status ok: within L1 0.01, fd-km4 (5 s).");
}

// Verdict, findings and limits of the closures use the same test for the agreement of two
// references.
TEST(Verdict, ConfirmsTheReferenceWhereTheFindingsExplainTheDifference) {
  for (const auto& [l1, agree] : {std::pair{0.0024, true}, std::pair{0.0035, false}}) {
    auto case_result = usual("a");
    solution_of(case_result, "mcs").sampling = {
        .y = 0.0011, .ydot = 0.0015, .y_99 = 0.0022, .ydot_99 = 0.003};
    set_l1(case_result, "fd-kf", "mcs", l1, 0.001);
    const auto run_verdict = make_run_verdict(run_of({case_result}));
    EXPECT_EQ(contains(run_verdict.recommendation[0], "fd-kf confirms these values"), agree)
        << run_verdict.recommendation[0];
    EXPECT_EQ(contains(run_verdict.recommendation[0], "fd-kf differs by more"), !agree)
        << run_verdict.recommendation[0];
    const auto found = case_finding_sentences(case_result);
    EXPECT_EQ(std::ranges::any_of(found,
                                  [](const auto& s) { return contains(s, "the densities agree"); }),
              agree);
  }
}

TEST(Verdict, StatesTheCasesInWhichTheReferenceIsConfirmed) {
  auto second = usual("b");
  solution_of(second, "fd-kf").status = transform::Status::failed;
  second.update_assessment();
  EXPECT_TRUE(make_run_verdict(run_of({usual("a"), second, usual("c")}))
                  .recommendation[0]
                  .ends_with("; fd-kf confirms these values in a, c only."));
  EXPECT_TRUE(make_run_verdict(run_of({second}))
                  .recommendation[0]
                  .ends_with("; no independent solution in this run confirms these values."));
}

TEST(Verdict, StatesNoAccuracyWithoutAnErrorEstimateOfTheReference) {
  auto case_result = usual("a");
  solution_of(case_result, "fd-kf").status = transform::Status::failed;
  solution_of(case_result, "mcs").sampling.reset();
  solution_of(case_result, "mcs").error = {.y_l1 = std::nan(""), .ydot_l1 = std::nan("")};
  case_result.update_assessment();
  const auto run_verdict = make_run_verdict(run_of({case_result}));
  EXPECT_EQ(run_verdict.answer[0], "The reference is mcs.");
  EXPECT_EQ(run_verdict.recommendation.size(), 1u);
}

TEST(Verdict, StatesThatThereIsNoReference) {
  const auto run_verdict = make_run_verdict(run_of({tests::case_with_first(4)}));
  ASSERT_EQ(run_verdict.answer.size(), 1u);
  EXPECT_TRUE(
      run_verdict.answer[0].starts_with("There is no reference: no solution of the full problem"));
  EXPECT_TRUE(run_verdict.lines.empty());
  EXPECT_TRUE(contains(run_verdict.recommendation.front(), "--methods fd,mcs"));
}

TEST(VerdictText, PutsFourCasesBesideEachOtherAt80Columns) {
  const auto run = run_of({usual("case1"), usual("case2"), usual("case3"), usual("case4")});
  const std::string text = run_verdict_text(run, make_run_verdict(run), 80);
  EXPECT_TRUE(contains(text, "case1") && contains(text, "case4"));
  EXPECT_EQ(text.find("solution"), text.rfind("solution  ")) << text;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_TRUE(contains(collapse_whitespace(text), "epc-gaussian-n2 0.03 0.004 0.03 0.004")) << text;
  EXPECT_TRUE(contains(collapse_whitespace(text), "~ inaccurate") == false &&
              contains(text, "! inadmissible"));
}

TEST(VerdictText, MarksTheReferenceAndIndistinguishableSolutions) {
  auto case_result = usual("a");
  set_l1(case_result, "fd-kf", "mcs", 0.0001, 0.0002);
  const std::string text = collapse_whitespace(text_of_run(run_of({case_result, usual("b")})));
  EXPECT_TRUE(contains(text, "fd-kf 1.0e-4 2.0e-4= 0.0012 0.0016")) << text;
  EXPECT_TRUE(contains(text, "mcs ref ref ref ref")) << text;
  EXPECT_TRUE(contains(text, "= indistinguishable")) << text;
}

TEST(VerdictText, OfOneCaseLeavesTheMatrixToItsTable) {
  EXPECT_FALSE(contains(text_of_run(run_of({usual("a")})), "(ref)"));
}

}  // namespace
}  // namespace fpkcheck::report
