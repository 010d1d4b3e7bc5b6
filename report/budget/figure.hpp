#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether a case has an error budget.
bool has_budget(const results::Case& case_result);

/// A gnuplot script that draws the error budget of a case on logarithmic axes, for each marginal in
/// L1 and in the tail. Each closure has a group of bars, a bar per part, with a black line at the
/// total. Bars of closures that are not ok are paler. In a single journal column the tails are
/// omitted.
/// @param file_stem name of script and picture without extension
std::string budget_script(const results::Case& case_result, const std::string& file_stem,
                          FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
