#pragma once

#include <string>

/// Styles of the parts of an error budget in all pictures and on the page.
namespace fpkcheck::report {

/// The colour of a part of the error budget, "#RRGGBB"; grey for a part that combines the errors of
/// several approximations.
/// @param part ErrorBudgetPart::name()
/// @throws InputError if the name contains an unknown approximation
const char* budget_part_colour(const std::string& part);

/// The gnuplot style of the bars of a part of the error budget, "with boxes ..".
/// @param faint whether the bars are paler, as for a closure that is not ok
std::string budget_part_bar_style(const std::string& part, bool faint);

/// The fill pattern of a part of the error budget in plotly.js, which distinguishes parts of
/// similar colour; empty for a solid fill.
const char* budget_part_fill_pattern(const std::string& part);

}  // namespace fpkcheck::report
