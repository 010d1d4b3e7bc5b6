#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::results {

/// Returns a sentence on the limiting error (the largest error) of each closure of a case. Another
/// sentence follows if the finite-volume solution and the simulation disagree. The text is empty if
/// the case has no error budget.
std::string limiting_errors_text(const CaseResult& case_result);

}  // namespace fpkcheck::results
