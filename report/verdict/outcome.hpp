#pragma once

#include <string>
#include <vector>

#include "results/run_assessment.hpp"

namespace fpkcheck::report {

using compare::Agreement;
using results::AgreementInCase;
using results::MarginalDistances;
using results::SolutionAgreements;

/// Returns the text of the L1 distances of p(y) and p(y'): "0.0061 in p(y) and 0.0051 in p(y')".
std::string l1_distances_text(const MarginalDistances& distances);

/// Returns the phrase for a number of cases: " in all 4 cases" or " in 2 of 4 cases". The phrase is
/// empty for a run of a single case.
std::string case_count_phrase(int count, int cases);

/// Returns the outcome of a solution over the cases in words: "reproduced: .." with the largest L1
/// distances, or "not reproduced: .." with the reason.
/// @param reference name of the reference, or several names if the references of the cases differ
/// @param cases number of cases of the run
std::string solution_outcome_text(const SolutionAgreements& row, const std::string& reference,
                                  int cases);

/// Returns the outcome of a solution without distances: "not_converged in all 4 cases: no solution
/// found".
std::string outcome_text_without_distances(const SolutionAgreements& row, int cases);

/// Returns the mark beside the distances of a solution in the matrix of the verdict. A mark
/// indicates a status other than `ok`, or that the solution is indistinguishable from the
/// reference. For all other solutions the mark is a blank.
char agreement_mark(const AgreementInCase& entry);

/// Returns the marks in the matrix of the verdict with their meanings, such as "~ inaccurate".
std::vector<std::string> agreement_mark_meanings(
    const std::vector<SolutionAgreements>& agreement_rows);

}  // namespace fpkcheck::report
