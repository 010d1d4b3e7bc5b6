#pragma once

#include <string>

#include "report/text/format.hpp"
#include "report/verdict/verdict.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The verdict in plain text: the answer, wrapped.
std::string answer_text(const Verdict& said, const TextFormat& format);

/// A row for each solution and a column for each case: both L1 distances to the case's reference, as
/// many cases beside each other as fit, with what its marks mean; then the verdict's lines and whom
/// to trust. Plain ASCII.
std::string verdict_text(const results::Run& run, const Verdict& said, const TextFormat& format);

}  // namespace fpkcheck::report
