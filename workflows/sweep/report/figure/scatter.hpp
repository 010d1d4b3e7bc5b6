#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of the larger L1 distance of both marginals to each point's reference, against
/// each of many keys: a point for each point and method, open where it is not ok, and the medians
/// of the ok ones over the bins of the key as a line.
std::string scatter_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
