#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::report {

/// Escapes a text for HTML, between tags and within a quoted attribute.
std::string escape_html(std::string_view text);

/// The HTML element <tag>text</tag>, with the text escaped.
std::string html_element(std::string_view tag, std::string_view text);

/// A closed <details> element with the given content; empty if the content is empty.
/// @param id id of the element, for links
std::string details_html(std::string_view id, std::string_view summary, const std::string& html);

/// The text of a table cell without a value.
inline constexpr std::string_view kNoValue = "\u2013";

enum class Align { left, right };

/// A column of an HTML table: plain text, with a cell for each row.
struct HtmlColumn {
  std::string header;
  Align align = Align::right;
  std::vector<std::string> cells = {};
  /// Whether the cells are names of statuses, which have the colour of the status.
  bool is_status = false;
};

/// An HTML table in a box that scrolls on a narrow screen. The first column has the names of the
/// rows. Columns without a value are omitted. The HTML is empty if the table has no rows, or no
/// column besides the names.
std::string table_html(std::string_view caption, std::vector<HtmlColumn> columns);

}  // namespace fpkcheck::report
