#pragma once

#include <string>
#include <vector>

#include "report/verdict/agreement.hpp"

namespace fpkcheck::report {

/// The mark beside the distances of a solution in the matrix. The mark shows a status that is not
/// ok, or that the solution is indistinguishable from the reference. Every other solution with
/// status ok has a blank.
char entry_mark(const AgreementEntry& entry);

/// The meanings of those marks that occur in the matrix rows: "~ inaccurate".
std::vector<std::string> mark_meanings(const std::vector<AgreementRow>& agreement_rows);

}  // namespace fpkcheck::report
