#pragma once

#include <string>
#include <vector>

#include "report/verdict/agreement.hpp"

namespace fpkcheck::report {

/// The mark beside the distances of a solution in the matrix: for its status, or for a solution
/// indistinguishable from the reference. A blank for any other solution with status ok.
char entry_mark(const AgreementEntry& entry);

/// The meanings of the marks that occur in the rows: "~ inaccurate".
std::vector<std::string> mark_meanings(const std::vector<AgreementRow>& agreement_rows);

}  // namespace fpkcheck::report
