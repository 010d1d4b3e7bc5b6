#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::report {

/// A text as it may stand in HTML, between tags and in a quoted attribute.
std::string escaped(std::string_view text);

/// <tag>text</tag>, the text escaped.
std::string element(std::string_view tag, std::string_view text);

/// JSON as it may stand inside a <script> element: no `<` that could end it.
std::string inside_script(std::string_view json);

/// What a cell shows where there is no value.
inline constexpr std::string_view kNoValue = "\u2013";

enum class Align { left, right };

/// One column of a table: plain texts, a cell for each row.
struct HtmlColumn {
  std::string header;
  Align align = Align::right;
  std::vector<std::string> cells = {};
};

/// A table in a box of its own, which scrolls where the screen is narrow. The first column names
/// the rows. Columns without a single value are left out, and nothing is made of a table without
/// rows, or with nothing but names.
std::string table_html(std::string_view caption, std::vector<HtmlColumn> columns);

}  // namespace fpkcheck::report
