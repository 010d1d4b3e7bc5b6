#pragma once

#include <string_view>

/// The source files of report.html. The files are compiled into the program, so that the program
/// needs no source file at run time.
namespace fpkcheck::report {

/// The text of page.html: the frame of the page, with the placeholders {{title}}, {{style}},
/// {{body}}, {{plots}}, {{plotly}} and {{script}}.
std::string_view page_frame();

/// The text of page.css, the style sheet.
std::string_view page_style();

/// The text of page.js, the script that draws the plots.
std::string_view page_script();

/// The text of the plotting library plotly.js (third_party/plotly), which page.js uses.
std::string_view plotly_script();

}  // namespace fpkcheck::report
