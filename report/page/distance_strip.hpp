#pragma once

#include <string>
#include <vector>

#include "report/verdict/standing.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The picture of the matrix, as SVG in the page: a row for each solution and a mark for each case at
/// the larger of both L1 distances, on a logarithmic axis, with the line up to which an answer is
/// called close and the error that the references know themselves to. Colours of text and lines are
/// those of the page. Empty where nothing has a distance.
std::string distance_strip(const results::Run& run, const std::vector<Record>& records);

}  // namespace fpkcheck::report
