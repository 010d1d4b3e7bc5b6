#pragma once

#include <string>
#include <vector>

#include "report/verdict/outcome.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The matrix of the verdict as an SVG picture. Each solution has a row with a mark for each case.
/// The position of a mark on the logarithmic axis is the larger of the L1 distances of p(y) and
/// p(y') to the reference. A line shows the limit compare::kCloseL1, and a rectangle shows the
/// error estimate of the references. Text and lines have the colours of the page. The picture is
/// empty if the run has no distances to a reference.
std::string distance_plot(const results::Run& run, const std::vector<AgreementRow>& agreement_rows);

}  // namespace fpkcheck::report
