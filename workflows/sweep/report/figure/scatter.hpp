#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script for plans with many keys: the larger L1 distance of both marginals to each
/// point's reference, against each key. There is a mark for each point and method, open where the
/// solution is not ok, and a line of the medians of the ok solutions over the bins of the key.
std::string scatter_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
