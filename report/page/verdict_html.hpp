#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

std::string verdict_paragraph_html(const std::string& sentence);

/// Returns the verdict, the first section of the report page: the answer, a matrix and a picture of
/// the distances, the outcome of each method, and the recommendation.
/// @param anchors ids of the sections of the cases, in the order of the cases
std::string verdict_html(const results::Run& run, const std::vector<std::string>& anchors);

}  // namespace fpkcheck::report
