#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/text/number_text.hpp"

/// Functions that make HTML elements, HTML tables and the data encoded in the report page.
namespace fpkcheck::report {

/// Escapes a text for use in HTML between tags or within a quoted attribute.
std::string escape_html(std::string_view text);

std::string html_element(std::string_view tag, std::string_view text);

/// Returns a closed HTML element <details>, or an empty text if `html` is empty.
std::string collapsible_html(std::string_view id, std::string_view summary,
                             const std::string& html);

enum class TextAlignment { left, right };

/// A column of an HTML table, with one cell of plain text for each row.
struct HtmlTableColumn {
  std::string header;
  TextAlignment align = TextAlignment::right;
  std::vector<std::string> cells = {};
  /// Whether the cells of the column are names of statuses, each shown in the colour of its status.
  bool is_status = false;
};

/// Returns an HTML table that scrolls on a narrow screen. The first column of the table contains
/// the names of the rows. Columns without any value are omitted. The returned text is empty for a
/// table without rows, or without columns besides the row names.
std::string table_html(std::string_view caption, std::vector<HtmlTableColumn> columns);

/// Encodes bytes in base64 (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

/// Compresses a text by gzip (RFC 1952) and encodes the result in base64. The script page.js
/// decodes the compressed text by DecompressionStream.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

/// An array of numbers in the JSON format of plotly.js: little-endian bytes in base64.
struct PlotlyNumberArray {
  std::string dtype;
  std::string bdata;
};

/// Converts numbers to an array of 32-bit floating-point numbers. Numbers of 32 bits in base64 have
/// seven significant digits and a third of the length of decimal text.
PlotlyNumberArray encode_float_array(std::span<const double> values);

/// Converts an array of numbers to the JSON object {"dtype", "bdata"}; nlohmann::json calls
/// to_json().
template <class Json>
void to_json(Json& json, const PlotlyNumberArray& array) {
  json = {{"dtype", array.dtype}, {"bdata", array.bdata}};
}

/// Returns a self-contained page with plots, which needs no other file and no network.
/// @param title title of the page, plain text
/// @param body HTML of the page, with plots_html() of all plots
/// @param plots JSON list of the groups of plots, the input of the script page.js
/// @throws std::bad_alloc
std::string page_with_plots_html(std::string_view title, const std::string& body,
                                 std::string_view plots);

// The source files of report.html are compiled into the program, which therefore needs no file at
// run time.

/// Returns the text of page.html with the placeholders {{title}}, {{style}}, {{body}}, {{plots}},
/// {{plotly}} and {{script}}.
std::string_view page_template();

std::string_view page_style();

std::string_view page_script();

std::string_view plotly_script();

}  // namespace fpkcheck::report
