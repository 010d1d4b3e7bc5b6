#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// True when a case has a budget that can be drawn.
bool has_budget(const results::Case& one);

/// A gnuplot script that draws a case's error budget: per variable, in L1 and in the tail, a group
/// of bars for each closure, one bar a part, on a logarithmic axis; a black line across the group
/// is the total, paler bars are those of closures that are not ok. One column of a journal has
/// the L1 alone.
std::string budget_script(const results::Case& one, const std::string& file_stem,
                          FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
