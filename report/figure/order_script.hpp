#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether at least one family of closures has two or more orders with known distances to the
/// reference.
bool has_several_orders(const results::CaseResult& case_result);

/// A gnuplot script that draws the L1 distances between closures and the reference against the
/// order n, with a curve for each family (report/convergence_over_order.hpp).
std::string order_script(const results::CaseResult& case_result, const std::string& file_stem,
                         FigureWidth width);

}  // namespace fpkcheck::report
