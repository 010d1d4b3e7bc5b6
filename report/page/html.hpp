#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/text/number_text.hpp"

/// HTML elements and tables, and data encoded in them.
namespace fpkcheck::report {

/// Escapes a text for HTML, between tags and within a quoted attribute.
std::string escape_html(std::string_view text);

/// The HTML element <tag>text</tag>, with the text escaped.
std::string html_element(std::string_view tag, std::string_view text);

/// A closed <details> element with the given content; empty if the content is empty.
/// @param id id of the element, for links
std::string details_html(std::string_view id, std::string_view summary, const std::string& html);

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

/// Base64 encoding of bytes (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

/// Compresses a text by gzip (RFC 1952) and encodes the result in base64; page.js unpacks the
/// result by DecompressionStream. Equal texts give equal results.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

/// An array of numbers in the JSON format of plotly.js: little-endian bytes in base64.
struct TypedArray {
  std::string dtype;
  std::string bdata;
};

/// Converts numbers to an array of 32-bit floating-point numbers, which keep seven digits in a
/// third of the characters of decimal text.
TypedArray float_array(std::span<const double> values);

/// The conversion to JSON that nlohmann::json calls: {"dtype", "bdata"}.
template <class Json>
void to_json(Json& json, const TypedArray& array) {
  json = {{"dtype", array.dtype}, {"bdata", array.bdata}};
}

// The source files of report.html, which are compiled into the program, so that the program needs
// no source file at run time.

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
