#pragma once

#include <string>

#include "report/text/format.hpp"
#include "report/verdict/verdict.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The answer of the verdict in plain text, broken into lines.
std::string verdict_answer_text(const Verdict& run_verdict, const TextFormat& format);

/// The verdict as plain ASCII text. A run of several cases has a matrix with a row for each
/// solution. For each case the row has both L1 distances to the reference of the case; as many
/// cases as fit are side by side. The meanings of the marks, the lines of the verdict and the
/// recommendation follow.
std::string verdict_text(const results::Run& run, const Verdict& run_verdict,
                         const TextFormat& format);

}  // namespace fpkcheck::report
