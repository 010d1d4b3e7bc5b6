#include "report/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "modified_case.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using tests::contains;
using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;
using transform::Status;

/// The only sentence with these words, or "".
std::string sentence_with(const results::CaseResult& case_result, const std::string& words) {
  std::string found;
  for (const auto& sentence : case_finding_sentences(case_result)) {
    if (!contains(sentence, words)) continue;
    EXPECT_TRUE(found.empty()) << found << "\n" << sentence;
    found = sentence;
  }
  return found;
}

TEST(Findings, StateTheErrorOfEachApproximation) {
  auto case_result = made_up_case();
  set_l1(case_result, "fd-white", "fd-kf", 0.011, 0.031);
  set_l1(case_result, "fd-km4", "fd-kf", 1e-4, 4e-4);
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.0024, 0.0047);
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.015, 0.0046);
  set_l1(case_result, "epc-gaussian-n4", "mcs", 0.0001, 0.0001);  // the closest, but inadmissible
  set_l1(case_result, "fd-kf", "mcs", 0.0012, 0.0016);
  const std::vector<std::string> expected{
      "Reference: mcs, the solution with the smallest error estimate (L1 0.001 in p(y), 0.002 in "
      "p(y')).",
      "L1 error of each approximation: white noise in place of the full jump integral (fd-white) "
      "0.011 in p(y) and 0.031 in p(y'); Kramers-Moyal series to the fourth derivative in place of "
      "the full jump integral (fd-km4) 0.0001 in p(y) and 0.0004 in p(y').",
      "Closest to mcs among the closures with status ok: epc-gaussian-n6 with L1 0.0024 in p(y) "
      "and 0.0047 in p(y').",
      "The simulation (mcs) and the full jump equation (fd-kf) differ by L1 0.0012 in p(y) and "
      "0.0016 in p(y'); the sampling error of the simulation (mcs) is 0.0011 in p(y) and 0.0015 in "
      "p(y'); all errors explain up to 0.003 and 0.0041 (exceeded by chance in 1 run of 1000): the "
      "densities agree."};
  EXPECT_EQ(case_finding_sentences(case_result), expected);
  set_l1(case_result, "fd-kf", "mcs", 0.0012, 0.016);
  EXPECT_TRUE(contains(case_finding_sentences(case_result)[3], "the densities disagree"))
      << case_finding_sentences(case_result)[3];
}

TEST(Findings, StateErrorsMeasuredWithControlVariates) {
  auto case_result = tests::made_up_case_with_control_variates();
  set_l1(case_result, "fd-kf", "mcs", 2.69e-5, 2.36e-5);
  for (auto& pair : case_result.pairs) {
    if (pair.l1_standard_error) pair.l1_standard_error = 5e-7;
  }
  solution_of(case_result, "fd-kf").error = {.y_l1 = 2.8e-5, .ydot_l1 = 2.3e-5};
  case_result.update_assessment();
  const std::string words = "measured by the simulation (mcs)";
  EXPECT_EQ(sentence_with(case_result, words),
            "The full jump equation (fd-kf) has an L1 error of 2.7e-05 +- 5e-07 in p(y) (estimate "
            "2.8e-05) and 2.4e-05 +- 5e-07 in p(y') (estimate 2.3e-05) over smooth bins, measured "
            "by the simulation (mcs).");
  EXPECT_EQ(sentence_with(case_result, "differ by"), "");
  // The error exceeds 1.25 times its estimate by more than the sampling error.
  solution_of(case_result, "fd-kf").error = {.y_l1 = 2.8e-5, .ydot_l1 = 1.2e-5};
  case_result.update_assessment();
  EXPECT_TRUE(contains(sentence_with(case_result, words), "(mcs): larger than the estimate."));
  // A distance below three sampling errors is not significant.
  set_l1(case_result, "fd-kf", "mcs", 8e-6, 2.36e-5);
  EXPECT_TRUE(contains(sentence_with(case_result, words),
                       "has an L1 error of at most 9e-06 (3 sampling errors of the simulation) in "
                       "p(y) (estimate 2.8e-05) and 2.4e-05 +- 5e-07 in p(y')"))
      << sentence_with(case_result, words);
  // With a smaller error estimate than that of the simulation, fd-kf is the reference.
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-8, .ydot_l1 = 1e-8};
  case_result.update_assessment();
  EXPECT_EQ(sentence_with(case_result, "measured by"), "");
  EXPECT_TRUE(contains(sentence_with(case_result, "differ by"), "the densities disagree"));
}

TEST(Findings, StateResidualBasedErrors) {
  auto case_result = tests::made_up_case_with_control_variates();
  case_result.moment_error_estimates = {
      {"epc-gaussian-n6", {}, {.y2 = 1, .v2 = 1}},
      {"fd-kf", {.y2 = 0.5, .v2 = 0.25}, {.y2 = 4.3e-7, .v2 = -1.2e-6}}};
  solution_of(case_result, "mcs").moments.y2 = 0.5 + 2e-9;
  solution_of(case_result, "mcs").moments.v2 = 0.25 - 1e-9;
  EXPECT_EQ(
      sentence_with(case_result, "residuals"),
      "Errors of E[y^2] and E[y'^2], estimated from residuals: 4.3e-07 and -1.2e-06 in fd-kf. "
      "Corrected moments of fd-kf: 0.5 and 0.25, within 2e-09 of the simulation.");
  case_result.moment_error_estimates.pop_back();
  EXPECT_EQ(sentence_with(case_result, "residuals"), "");
}

// The number of digits is clamped: for a value near 0 it was -2147483648.
TEST(Findings, ClampTheNumberOfDigits) {
  auto case_result = tests::made_up_case_with_control_variates();
  case_result.moment_error_estimates = {{"fd-kf", {.y2 = 0, .v2 = 1e308}, {.y2 = 1, .v2 = 1}}};
  const std::string sentence = sentence_with(case_result, "estimated from residuals");
  EXPECT_TRUE(contains(sentence, "moments of fd-kf: 0 and 1e+308")) << sentence;
}

TEST(Findings, ComparesEquationsOfOneMethodThatDifferInOneRespectAlone) {
  auto case_result = made_up_case();
  auto& white = solution_of(case_result, "fd-white").identity;
  white.equation = DensityEquation::km4;
  white.impact = ImpactCondition::delta;
  set_l1(case_result, "fd-white", "fd-km4", 0.021, 0.022);
  const auto text = sentence_with(case_result, "error of each approximation");
  EXPECT_TRUE(contains(text,
                       "; the impact to first order in 1-r in place of exact (fd-white) "
                       "0.021 in p(y) and 0.022 in p(y')."))
      << text;
  EXPECT_FALSE(contains(text, "white noise")) << text;
  white.method = "another";
  EXPECT_FALSE(contains(sentence_with(case_result, "error of each approximation"), "the impact"));
}

TEST(Findings, RankClosuresByTheStatedReference) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  set_l1(case_result, "epc-gaussian-n2", "fd-kf", 0.001, 0.001);
  set_l1(case_result, "epc-gaussian-n6", "fd-kf", 0.002, 0.001);
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.002, 0.001);
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.001, 0.001);
  EXPECT_TRUE(case_finding_sentences(case_result)[0].starts_with("Reference: fd-kf,"))
      << case_finding_sentences(case_result)[0];
  EXPECT_EQ(
      sentence_with(case_result, "Closest to"),
      "Closest to fd-kf among the closures with status ok: epc-gaussian-n2 with L1 0.001 in p(y) "
      "and 0.001 in p(y').");
}

TEST(Findings, RankNothingWithinTheErrorOfTheReference) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.005, 0.0046);
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.0024, 0.0047);  // mcs: 0.0011 and 0.0015
  EXPECT_EQ(sentence_with(case_result, "Closest to"),
            "Closest to mcs among the closures with status ok: epc-gaussian-n6, epc-gaussian-n2 "
            "(indistinguishable) with L1 at most 0.005 in p(y) and 0.0047 in p(y'). "
            "Indistinguishable: the distances differ by no more than the error estimate of the "
            "reference.");
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.0052, 0.0046);
  EXPECT_FALSE(contains(sentence_with(case_result, "Closest to"), "epc-gaussian-n2"));
}

TEST(Findings, NameTheClosestClosureOfEachFamilyAndFormulation) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.015, 0.015);
  EXPECT_FALSE(contains(sentence_with(case_result, "Closest to"), "epc-gaussian-n2"));
  auto& identity = solution_of(case_result, "epc-gaussian-n2").identity;
  identity.formulation = "moment";
  EXPECT_TRUE(contains(sentence_with(case_result, "Closest to"), "; epc-gaussian-n2 with"));
  EXPECT_TRUE(contains(sentence_with(case_result, "Closest to"), "epc-gaussian-n6 with"));
  identity.formulation = "gaussian";
  identity.family = "toy";
  EXPECT_TRUE(contains(sentence_with(case_result, "Closest to"), "; epc-gaussian-n2 with"));
}

TEST(Findings, CallNoClosureCloseAboveTheStatedDistance) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.5, 0.5);
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.01, 0.2);
  EXPECT_EQ(sentence_with(case_result, "Closest to"), "");
  EXPECT_EQ(
      sentence_with(case_result, "No closure"),
      "No closure with status ok is within L1 0.02 of mcs: the closest, epc-gaussian-n6, has L1 "
      "0.01 in p(y) and 0.2 in p(y').");
}

TEST(Findings, StateTheDiscretisationError) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").error = {2.8e-5, 2.5e-5, {.y2 = 1.3e-6, .v2 = 2.4e-6}};
  case_result.update_assessment();
  EXPECT_EQ(sentence_with(case_result, "discretisation error"),
            "");  // the error budget contains the error
  case_result.budget.clear();
  EXPECT_EQ(sentence_with(case_result, "discretisation error"),
            "The discretisation error of fd-kf, by its own estimate: L1 2.8e-05 in p(y) and "
            "2.5e-05 in p(y'), 1e-06 in E[y^2] and 2e-06 in E[y'^2].");
  solution_of(case_result, "fd-km4").error = {3e-5, 1e-5, {.y2 = 4e-6, .v2 = 1e-6}};
  case_result.update_assessment();
  EXPECT_EQ(sentence_with(case_result, "discretisation error"),
            "The discretisation errors of fd-km4, fd-kf, by their own estimate: at most L1 3e-05 "
            "in p(y) and 2.5e-05 in p(y'), 4e-06 in E[y^2] and 2e-06 in E[y'^2].");
}

TEST(Findings, StateTheSamplingError) {
  auto case_result = made_up_case();
  auto& mcs = solution_of(case_result, "mcs");
  mcs.sampling = transform::MarginalSamplingErrors{.y = 3e-3, .ydot = 2e-3};
  mcs.standard_errors = transform::MomentStandardErrors{.moments = {.y2 = 4e-4, .v2 = 5e-4}};
  EXPECT_EQ(sentence_with(case_result, "The sampling error of"),
            "");  // the error budget contains it
  case_result.budget.clear();
  EXPECT_EQ(sentence_with(case_result, "The sampling error of"),
            "The sampling error of mcs: on average L1 0.003 in p(y) and 0.002 in p(y'); standard "
            "errors 0.0004 in E[y^2] and 0.0005 in E[y'^2].");
}

TEST(Findings, UseOnlyAvailableSolutionsThatAreOk) {
  auto case_result = made_up_case();
  for (auto& solution : case_result.solutions) {
    if (solution.identity.role == transform::SolutionRole::closure)
      solution.status = Status::failed;
  }
  solution_of(case_result, "fd-white").status = Status::failed;
  solution_of(case_result, "mcs").sampling.reset();
  case_result.update_assessment();
  const auto sentences = case_finding_sentences(case_result);
  ASSERT_EQ(sentences.size(), 4u);
  EXPECT_EQ(sentences[0], "Reference: mcs.");
  EXPECT_FALSE(contains(sentences[1], "white noise")) << sentences[1];
  EXPECT_EQ(sentences[2], "No closure has status ok.");
  EXPECT_FALSE(contains(sentences[3], "sampling")) << sentences[3];

  case_result.solutions.erase(case_result.solutions.begin() + 4, case_result.solutions.end());
  case_result.update_assessment();
  ASSERT_EQ(case_finding_sentences(case_result).size(), 1u);
  EXPECT_TRUE(case_finding_sentences(case_result)[0].starts_with("There is no reference"))
      << case_finding_sentences(case_result)[0];
  case_result.solutions.resize(1);
  case_result.update_assessment();
  EXPECT_TRUE(case_finding_sentences(case_result).empty());
}

/// The case with epc-gaussian-n2 as an external density.
results::CaseResult with_a_file() {
  auto case_result = made_up_case();
  auto& file = solution_of(case_result, "epc-gaussian-n2");
  file.identity.role = transform::SolutionRole::external;
  set_l1(case_result, file.id(), "mcs", 0.003, 0.004);
  set_l1(case_result, file.id(), "fd-kf", 0.005, 0.006);
  return case_result;
}

TEST(Findings, StateDistancesOfAFileToFullProblemSolutions) {
  auto case_result = with_a_file();
  const std::string to_mcs =
      "epc-gaussian-n2 differs from the simulation (mcs) by L1 0.003 in "
      "p(y) and 0.004 in p(y')";
  const std::string to_kf =
      "epc-gaussian-n2 differs from the full jump equation (fd-kf) by L1 "
      "0.005 in p(y) and 0.006 in p(y')";
  EXPECT_EQ(sentence_with(case_result, "from the simulation"), to_mcs + ".");
  EXPECT_EQ(sentence_with(case_result, "from the full jump equation"), to_kf + ".");

  // Combined sampling errors of the file and the simulation (0.0011, 0.0015); the 99 % quantile is
  // twice the expectation.
  solution_of(case_result, "epc-gaussian-n2").sampling = {.y = 0.0011, .ydot = 0.002};
  case_result.update_assessment();
  EXPECT_EQ(
      sentence_with(case_result, "from the simulation"),
      to_mcs +
          "; its standard errors and those of mcs account for about 0.0016 in p(y) and "
          "0.0025 in p(y'); all errors explain up to 0.0042 and 0.0068 (exceeded by chance in 1 "
          "run of 1000): the densities agree.");
  EXPECT_EQ(
      sentence_with(case_result, "from the full jump equation"),
      to_kf +
          "; its standard errors account for about 0.0011 in p(y) and 0.002 in p(y'); all errors "
          "explain up to 0.003 and 0.0054 (exceeded by chance in 1 run of 1000): the densities "
          "disagree.");
}

TEST(Findings, AssessAFileInItsMarginalsOnly) {
  auto case_result = with_a_file();
  std::erase_if(case_result.pairs, [](const auto& pair) {
    return pair.a == "epc-gaussian-n2" && pair.variable == transform::StateVariable::ydot;
  });
  solution_of(case_result, "epc-gaussian-n2").sampling = {.y = 0.0011};
  case_result.update_assessment();
  EXPECT_EQ(sentence_with(case_result, "from the simulation"),
            "epc-gaussian-n2 differs from the simulation (mcs) by L1 0.003 in p(y); its standard "
            "errors and those of mcs account for about 0.0016 in p(y); all errors explain up to "
            "0.0042 (exceeded by chance in 1 run of 1000): the densities agree.");
}

TEST(Findings, HaveTheNotesOfSolvers) {
  auto case_result = made_up_case();
  auto& metrics = solution_of(case_result, "epc-gaussian-n2").metrics;
  metrics = transform::SolverMetricsBuilder()
                .add_text_metric("files[0].file", std::string("/data/lab.csv"))
                .add_text_metric("files[0].notes[0]", std::string("sorted"))
                .add_text_metric("files[0].notes[1]", std::string("2 rows were left out"))
                .add_empty_list("files[1].notes")
                .add_text_metric("keynotes[0]", std::string("no note"))
                .take_metrics();
  EXPECT_EQ(case_finding_sentences(case_result).back(),
            "Note on lab.csv: sorted; 2 rows were left out.");
  metrics = transform::SolverMetricsBuilder()
                .add_text_metric("notes[0]", std::string("by hand"))
                .take_metrics();
  EXPECT_EQ(case_finding_sentences(case_result).back(), "Note on epc-gaussian-n2: by hand.");
}

}  // namespace
}  // namespace fpkcheck::report
