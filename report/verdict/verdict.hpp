#pragma once

#include <string>
#include <vector>

#include "report/text/text_layout.hpp"
#include "results/run.hpp"
#include "results/run_assessment.hpp"

namespace fpkcheck::report {

using compare::AgreementWithReference;
using results::MarginalDistances;
using results::SolutionAgreementInCase;
using results::SolutionAgreementOverCases;

/// Returns the text of the L1 distances of p(y) and p(y'): "0.0061 in p(y) and 0.0051 in p(y')".
std::string l1_distances_text(const MarginalDistances& distances);

/// Returns the phrase for a number of cases: " in all 4 cases" or " in 2 of 4 cases". For a run of
/// a single case the phrase on the number of cases is empty.
std::string case_count_text(int count, int cases);

/// Returns the outcome of a solution over the cases in words: "reproduced: .." with the largest L1
/// distances, or "not reproduced: .." with the reason.
/// @param reference name of the reference, or several names if the references of the cases differ
/// @param cases number of cases of the run
std::string solution_outcome_text(const SolutionAgreementOverCases& row,
                                  const std::string& reference, int cases);

/// Returns the outcome of a solution without distances: "not_converged in all 4 cases: no solution
/// found".
std::string outcome_text_without_distances(const SolutionAgreementOverCases& row, int cases);

/// Returns the mark beside the L1 distances of a solution in the verdict's matrix of solutions and
/// cases. A mark in the verdict indicates a status other than `ok`, or that the solution is
/// indistinguishable from the reference solution. A solution that is `ok` and distinguishable from
/// the reference solution has a blank as mark.
char agreement_symbol(const SolutionAgreementInCase& entry);

/// Returns the marks in the verdict's matrix of solutions and cases with their meanings, such as "~
/// inaccurate".
std::vector<std::string> agreement_symbol_meanings(
    const std::vector<SolutionAgreementOverCases>& agreement_rows);

/// One line of the verdict on a run: the outcome of a method, or of one order of a closure.
struct MethodVerdictLine {
  std::string subject;  ///< id or family, such as "epc-gaussian-n6" or "epc-polar"
  bool reproduced;      ///< whether the method reproduces the reference in each of its cases
  std::string outcome;  ///< "reproduced: L1 distance at most 0.0061 in p(y) and 0.0051 in p(y')"
};

/// The main result (verdict) of a run, printed before all tables.
struct RunVerdict {
  /// Rows of the verdict's matrix of L1 distances, one for each solution.
  std::vector<SolutionAgreementOverCases> agreement_rows;
  /// Paragraphs on contradictions with the guaranteed bounds, on the accuracy of the reference
  /// solution, and on the solutions that reproduce the reference solution.
  std::vector<std::string> answer;
  /// Outcomes of the methods, one line each. The verdict has a line for each order of the paper's
  /// closure (with the impact condition to first order in 1-r), for each further formulation, for
  /// each approximate equation, and for each external density or family of densities.
  std::vector<MethodVerdictLine> lines;
  /// Sentences that recommend a solution for reference values and the fastest method of sufficient
  /// accuracy, with the reasons.
  std::vector<std::string> recommendation;
};

RunVerdict make_run_verdict(const results::Run& run);

/// Returns the main result of a run, RunVerdict::answer, in plain text, broken into lines.
std::string verdict_answer_text(const RunVerdict& run_verdict, const TerminalTextFormat& format);

/// Returns the verdict on a run as plain ASCII text. The verdict on several cases has a matrix with
/// one row for each solution. The matrix row of a solution has the L1 distances of p(y) and p(y')
/// from the reference solution of each case. As many cases as fit are side by side. Below the
/// matrix of L1 distances are the meanings of its marks, the lines of the verdict and the
/// recommendation.
std::string run_verdict_text(const results::Run& run, const RunVerdict& run_verdict,
                             const TerminalTextFormat& format);

}  // namespace fpkcheck::report
