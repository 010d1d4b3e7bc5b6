#pragma once

#include <string>
#include <vector>

#include "report/verdict/agreement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The matrix of the verdict as an SVG picture: a row for each solution, and for each case a mark
/// at the larger of both L1 distances to the reference, on a logarithmic axis. A line shows
/// kCloseL1, a rectangle the error estimate of the references. Text and lines have the colours of
/// the page. Empty without distances.
std::string distance_plot(const results::Run& run, const std::vector<AgreementRow>& agreement_rows);

}  // namespace fpkcheck::report
