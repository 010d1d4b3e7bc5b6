#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// A sentence on the limiting error of each closure of a case, by the assessment of the case. A
/// second sentence follows if the finite-volume solution and the simulation disagree. The text is
/// empty without an error budget.
std::string limiting_errors_text(const CaseResult& case_result);

}  // namespace fpkcheck::results
