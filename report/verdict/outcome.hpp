#pragma once

#include <string>
#include <vector>

#include "results/run_assessment.hpp"

namespace fpkcheck::report {

using compare::Agreement;
using results::AgreementEntry;
using results::AgreementRow;
using results::MarginalDistances;

/// The text of the L1 distances of both marginal densities: "0.0061 in p(y) and 0.0051 in p(y')".
std::string distances_text(const MarginalDistances& distances);

/// The phrase for a number of cases: " in all 4 cases", " in 2 of 4 cases"; empty for a run of a
/// single case.
std::string cases_phrase(int count, int cases);

/// The outcome of a solution over the cases in words: "reproduced: L1 distance at most ..", "not
/// reproduced: inadmissible in all 4 cases: no probability density".
/// @param reference name of the reference, or names if the references of the cases differ
/// @param cases number of cases of the run
std::string outcome_text(const AgreementRow& row, const std::string& reference, int cases);

/// The outcome of a solution without distances: "not_converged in all 4 cases: no solution found".
std::string outcome_text_without_distances(const AgreementRow& row, int cases);

/// The mark beside the distances of a solution in the matrix. The mark shows a status that is not
/// ok, or that the solution is indistinguishable from the reference. A solution with status ok has
/// a blank as mark, unless the solution is indistinguishable from the reference.
char entry_mark(const AgreementEntry& entry);

/// The meanings of those marks that occur in the matrix rows: "~ inaccurate".
std::vector<std::string> mark_meanings(const std::vector<AgreementRow>& agreement_rows);

}  // namespace fpkcheck::report
