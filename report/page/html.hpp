#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::report {

/// A text as it may stand in HTML, between tags and in a quoted attribute.
std::string escaped(std::string_view text);

/// <tag>text</tag>, the text escaped.
std::string element(std::string_view tag, std::string_view text);

/// <details>, closed, with what it is to show; empty where there is nothing.
/// @param id of the element, for links
std::string folded(std::string_view id, std::string_view summary, const std::string& html);

/// What a cell shows where there is no value.
inline constexpr std::string_view kNoValue = "\u2013";

enum class Align { left, right };

/// One column of a table: plain texts, a cell for each row.
struct HtmlColumn {
  std::string header;
  Align align = Align::right;
  std::vector<std::string> cells = {};
  /// Cells are statuses: in colour, by what they mean.
  bool is_status = false;
};

/// A table in a box of its own, which scrolls where the screen is narrow. The first column names
/// the rows. Columns without a single value are left out, and nothing is made of a table without
/// rows, or with nothing but names.
std::string table_html(std::string_view caption, std::vector<HtmlColumn> columns);

}  // namespace fpkcheck::report
