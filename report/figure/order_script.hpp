#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether some family has two orders whose distances to the reference are known.
bool has_orders(const results::Case& one);

/// The gnuplot script that draws L1 distances of families over their orders (report/convergence.hpp).
std::string order_script(const results::Case& one, const std::string& file_stem, FigureWidth width);

}  // namespace fpkcheck::report
