#pragma once

#include <string>

/// How the parts of an error budget look, in every picture and on the page.
namespace fpkcheck::report {

/// The colour of a part, "#RRGGBB"; of several links together grey.
/// @param part BudgetPart::name()
/// @throws InputError when it names no link
const char* part_colour(const std::string& part);

/// How gnuplot draws its bars, "with boxes ..".
/// @param faint of a closure that is not ok
std::string part_boxes(const std::string& part, bool faint);

/// Its hatching, as plotly.js names it, since its colour alone need not tell it from the others;
/// empty for none.
const char* part_pattern(const std::string& part);

}  // namespace fpkcheck::report
