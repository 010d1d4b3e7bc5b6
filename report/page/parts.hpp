#pragma once

#include <string_view>

/// The source files of report.html, compiled in, so that the program does not need them at run
/// time.
namespace fpkcheck::report {

/// page.html: the frame, with the placeholders {{title}}, {{style}}, {{body}}, {{plots}},
/// {{plotly}} and {{script}}.
std::string_view page_frame();

/// page.css: the style sheet.
std::string_view page_style();

/// page.js: draws the plots.
std::string_view page_script();

/// third_party/plotly: the plotting library used by page.js.
std::string_view plotly_script();

}  // namespace fpkcheck::report
