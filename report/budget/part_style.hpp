#pragma once

#include <string>

/// Styles of the parts of an error budget in all pictures and on the page.
namespace fpkcheck::report {

/// The colour of a part, "#RRGGBB"; grey for several links together.
/// @param part BudgetPart::name()
/// @throws InputError if the name contains an unknown link
const char* part_colour(const std::string& part);

/// The gnuplot style of the bars of a part, "with boxes ..".
/// @param faint paler, for a closure that is not ok
std::string part_boxes(const std::string& part, bool faint);

/// The fill pattern of a part in plotly.js, since colours alone may look alike; empty for none.
const char* part_pattern(const std::string& part);

}  // namespace fpkcheck::report
