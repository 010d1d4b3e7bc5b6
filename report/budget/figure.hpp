#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether a case has an error budget.
bool has_budget(const results::CaseResult& case_result);

/// A gnuplot script that draws the error budget of a case on logarithmic axes: for each marginal
/// density a panel of the L1 distances and a panel of the tail distances. Each closure has a group
/// of bars, with a bar for each part of the error budget and a black line at the total distance.
/// Closures whose status is not ok have paler bars. A figure for a single journal column omits the
/// panels of the tail distances.
/// @param file_stem file name of the script and of its picture, without extension
std::string budget_script(const results::CaseResult& case_result, const std::string& file_stem,
                          FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
