#pragma once

#include <string>
#include <vector>

#include "report/verdict/standing.hpp"

namespace fpkcheck::report {

/// The mark beside the distances of a solution in the matrix: for its status, or for a solution
/// indistinguishable from the reference. A blank for any other solution with status ok.
char mark_of(const Stand& stand);

/// The meanings of the marks that occur in the rows: "~ inaccurate".
std::vector<std::string> meanings_of_marks(const std::vector<Record>& records);

}  // namespace fpkcheck::report
