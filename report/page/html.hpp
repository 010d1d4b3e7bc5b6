#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::report {

/// Escapes a text for HTML, between tags and within a quoted attribute.
std::string escape_html(std::string_view text);

/// <tag>text</tag>, with escapes in the text.
std::string element(std::string_view tag, std::string_view text);

/// A closed <details> element with this content; empty without content.
/// @param id of the element, for links
std::string details_html(std::string_view id, std::string_view summary, const std::string& html);

/// Text of a cell without a value.
inline constexpr std::string_view kNoValue = "\u2013";

enum class Align { left, right };

/// A column of a table: plain text, a cell for each row.
struct HtmlColumn {
  std::string header;
  Align align = Align::right;
  std::vector<std::string> cells = {};
  /// Cells are names of statuses, coloured by status.
  bool is_status = false;
};

/// A table in a box that scrolls on a narrow screen. The first column has the names of the rows.
/// Columns without a value are omitted. Empty without rows, or without columns beside the names.
std::string table_html(std::string_view caption, std::vector<HtmlColumn> columns);

}  // namespace fpkcheck::report
