#pragma once

#include <string>
#include <vector>

#include "report/verdict/standing.hpp"

namespace fpkcheck::report {

/// What stands beside the distances of a solution in the matrix: of its status, or that it cannot be
/// told from the reference; a blank where it is ok.
char mark_of(const Stand& stand);

/// What the marks mean that stand somewhere in the records: "~ inaccurate".
std::vector<std::string> meanings_of_marks(const std::vector<Record>& records);

}  // namespace fpkcheck::report
