#pragma once

#include <string_view>

/// The files that report.html is put together from, compiled in so that the program needs none of
/// them where it runs.
namespace fpkcheck::report {

/// page.html: the frame, with {{title}}, {{style}}, {{body}}, {{plots}}, {{plotly}} and {{script}}
/// where the parts go.
std::string_view page_frame();

/// page.css
std::string_view page_style();

/// page.js: draws the plots.
std::string_view page_script();

/// third_party/plotly: the library that page.js draws with.
std::string_view plotly_script();

}  // namespace fpkcheck::report
