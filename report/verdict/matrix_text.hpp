#pragma once

#include <string>

#include "report/text/format.hpp"
#include "report/verdict/verdict.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The answer of the verdict in plain text with line breaks.
std::string answer_text(const Verdict& run_verdict, const TextFormat& format);

/// The matrix of several cases: a row for each solution, and for each case both L1 distances to its
/// reference, as many cases side by side as fit, with the meanings of the marks. The lines of the
/// verdict and the recommendation follow. Plain ASCII.
std::string verdict_text(const results::Run& run, const Verdict& run_verdict,
                         const TextFormat& format);

}  // namespace fpkcheck::report
