#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// A sentence of the answer, as it opens the page.
std::string answer_html(const std::string& sentence);

/// What a reader meets first: the answer, solutions over cases with their distances, the picture of
/// these, what became of each closure, and whom to trust.
/// @param anchors ids of the sections of the cases, in their order
std::string verdict_html(const results::Run& run, const std::vector<std::string>& anchors);

}  // namespace fpkcheck::report
