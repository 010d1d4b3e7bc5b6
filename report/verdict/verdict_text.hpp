#pragma once

#include <string>

#include "report/text/text_format.hpp"
#include "report/verdict/verdict.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns the answer of the verdict in plain text, broken into lines.
std::string verdict_answer_text(const Verdict& run_verdict, const TextFormat& format);

/// Returns the verdict as plain ASCII text. A run of several cases has a matrix with one row for
/// each solution. The row of a solution has the L1 distances of p(y) and p(y') from the reference
/// of each case. As many cases as fit are side by side. Below the matrix are the meanings of its
/// marks, the lines of the verdict and the recommendation.
std::string verdict_text(const results::Run& run, const Verdict& run_verdict,
                         const TextFormat& format);

}  // namespace fpkcheck::report
