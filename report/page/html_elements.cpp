#include "report/page/html_elements.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cctype>
#include <map>
#include <new>
#include <span>
#include <vector>

namespace fpkcheck::report {
namespace {

std::string_view css_class(const HtmlTableColumn& column) {
  return column.align == TextAlignment::right ? " class=\"number\"" : "";
}

// The CSS class of a status chip, which sets the colour, is the name of the status.
std::string status_chip(const std::string& status) {
  std::string letters = status;
  std::ranges::replace_if(
      letters, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return fmt::format("<span class=\"chip {}\">{}</span>", letters, status);
}

bool is_empty_column(const HtmlTableColumn& column) {
  return std::ranges::all_of(column.cells, [](const auto& cell) { return cell == kNoValue; });
}

// Replaces the {{placeholders}} of the page template in a single pass, so that placeholders within
// inserted texts are unchanged.
std::string fill_template(std::string_view frame,
                          const std::map<std::string, std::string_view>& parts) {
  std::string page;
  while (true) {
    const auto begin = frame.find("{{");
    page += frame.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    const auto end = frame.find("}}", begin);
    page += parts.at(std::string(frame.substr(begin + 2, end - begin - 2)));
    frame.remove_prefix(end + 2);
  }
}

}  // namespace

std::string escape_html(std::string_view text) {
  constexpr std::pair<char, std::string_view> kEscapes[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string html;
  html.reserve(text.size());
  for (const char c : text) {
    const auto* const escape =
        std::ranges::find(kEscapes, c, &std::pair<char, std::string_view>::first);
    html += escape == std::end(kEscapes) ? std::string_view(&c, 1) : escape->second;
  }
  return html;
}

std::string html_element(std::string_view tag, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>\n", tag, escape_html(text));
}

std::string collapsible_html(std::string_view id, std::string_view summary,
                             const std::string& html) {
  if (html.empty()) return "";
  return fmt::format("<details id=\"{}\">\n<summary>{}</summary>\n{}</details>\n", escape_html(id),
                     escape_html(summary), html);
}

std::string table_html(std::string_view caption, std::vector<HtmlTableColumn> columns) {
  if (columns.empty() || columns.front().cells.empty()) return "";
  std::erase_if(columns, is_empty_column);
  if (columns.size() < 2) return "";
  std::string html = fmt::format(
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\">\n"
      "<table>\n<caption>{0}</caption>\n<thead><tr>",
      escape_html(caption));
  for (const auto& column : columns) {
    html +=
        fmt::format("<th scope=\"col\"{}>{}</th>", css_class(column), escape_html(column.header));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < columns.front().cells.size(); ++row) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape_html(columns.front().cells[row]));
    for (std::size_t c = 1; c < columns.size(); ++c) {
      const std::string cell = escape_html(columns[c].cells.at(row));
      html += fmt::format("<td{}>{}</td>", css_class(columns[c]),
                          columns[c].is_status ? status_chip(cell) : cell);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string encode_base64(std::span<const std::byte> bytes) {
  namespace it = boost::archive::iterators;
  using Encoder = it::base64_from_binary<it::transform_width<const char*, 6, 8>>;
  // The compressed bytes are padded, since Boost's base64 iterators read whole groups of three
  // bytes.
  std::vector<char> padded((bytes.size() + 2) / 3 * 3, 0);
  std::ranges::transform(bytes, padded.begin(), [](std::byte b) { return static_cast<char>(b); });
  std::string text(Encoder(padded.data()), Encoder(padded.data() + padded.size()));
  const std::size_t padding = padded.size() - bytes.size();
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

std::string gzip_base64(std::string_view text) {
  constexpr int kGzip = 16, kWindowBits = 15, kMemoryLevel = 9;
  z_stream stream{};
  // Since the parameters of deflateInit2() are valid and the buffer is large enough, a lack of
  // memory is the only possible error. The highest compression level of zlib would make plotly.js 3
  // % smaller than the default level, and take five times as long.
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kWindowBits + kGzip, kMemoryLevel,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  std::vector<std::byte> bytes(deflateBound(&stream, text.size()));
  // The function deflate() of zlib does not modify the input, although `next_in` is not const.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::bad_alloc();
  return encode_base64(bytes);
}

static_assert(std::endian::native == std::endian::little, "plotly.js reads little-endian numbers");

PlotlyNumberArray encode_float_array(std::span<const double> values) {
  const std::vector<float> rounded(values.begin(), values.end());
  return {"f4", encode_base64(std::as_bytes(std::span(rounded)))};
}

std::string page_with_plots_html(std::string_view title, const std::string& body,
                                 std::string_view plots) {
  // The text of plotly.js is constant, and is therefore compressed only once per process.
  static const std::string plotly = gzip_base64(plotly_script());
  return fill_template(page_template(), {{"title", escape_html(title)},
                                         {"style", page_style()},
                                         {"body", body},
                                         {"plots", gzip_base64(plots)},
                                         {"plotly", plotly},
                                         {"script", page_script()}});
}

}  // namespace fpkcheck::report
