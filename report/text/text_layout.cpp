#include "report/text/text_layout.hpp"

#include <fmt/color.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "transform/solution.hpp"

namespace fpkcheck::report {
namespace {

std::size_t table_width(const std::vector<TextTableColumn>& shown_columns, std::size_t gap) {
  std::size_t total = 0;
  for (const auto& column : shown_columns) total += column.column_width() + gap;
  return total - std::min(total, gap);
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

fmt::text_style status_style(const std::string& cell) {
  using transform::Status;
  const auto status = base::enum_from_name<Status>(cell);
  if (status == Status::ok) return fmt::fg(fmt::terminal_color::green);
  if (status == Status::failed || status == Status::ill_posed) {
    return fmt::fg(fmt::terminal_color::red);
  }
  return fmt::fg(fmt::terminal_color::yellow);
}

std::string group_header_line(const std::vector<TextTableColumn>& all, const std::string& gap) {
  std::string line;
  for (std::size_t c = 0; c < all.size();) {
    std::size_t span = all[c].column_width(), next = c + 1;
    for (; next < all.size() && !all[c].group.empty() && all[next].group == all[c].group; ++next) {
      span += gap.size() + all[next].column_width();
    }
    const std::string text = all[c].group.empty() ? "" : ' ' + all[c].group + ' ';
    line += fmt::format(fmt::runtime(text.empty() ? "{: ^{}}" : "{:-^{}}"), text, span) + gap;
    c = next;
  }
  return without_trailing_spaces(line);
}

std::string align_cell(const TextTableColumn& column, const std::string& text) {
  return column.left_aligned ? fmt::format("{:<{}}", text, column.column_width())
                             : fmt::format("{:>{}}", text, column.column_width());
}

std::string header_line(const std::vector<TextTableColumn>& all, const std::string& gap) {
  std::string line;
  for (const auto& column : all) line += align_cell(column, column.header) + gap;
  return without_trailing_spaces(line);
}

std::string row_line(const std::vector<TextTableColumn>& all, const std::string& gap, std::size_t k,
                     bool colour) {
  std::string line;
  for (const auto& column : all) {
    const std::string& cell = column.cells[k];
    const std::string text = align_cell(column, cell);
    line += (colour && column.is_status ? fmt::format(status_style(cell), "{}", text) : text) + gap;
  }
  return without_trailing_spaces(line);
}

std::string bold_line(const std::string& line) {
  return fmt::format(fmt::emphasis::bold, "{}", line.substr(0, line.size() - 1)) + '\n';
}

}  // namespace

std::size_t TextTableColumn::column_width() const {
  std::size_t width = header.size();
  for (const auto& cell : cells) width = std::max(width, cell.size());
  return width;
}

void add_table_row(std::vector<TextTableColumn>& columns, const std::vector<std::string>& cells) {
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k].cells.push_back(cells.at(k));
}

TextTableColumn make_status_column() { return {"", "status", true, kAlwaysShown, {}, true}; }

std::vector<TextTableColumn> select_columns_to_fit(std::vector<TextTableColumn> columns,
                                                   const TerminalTextFormat& format) {
  while (table_width(columns, 1) > format.width) {
    const int least =
        std::ranges::min_element(columns, {}, &TextTableColumn::importance)->importance;
    if (least == kAlwaysShown) break;
    std::erase_if(columns,
                  [&](const TextTableColumn& column) { return column.importance == least; });
  }
  return columns;
}

std::string omitted_column_names(const std::vector<TextTableColumn>& all,
                                 const std::vector<TextTableColumn>& shown) {
  std::vector<std::string> names;
  for (const auto& column : all) {
    const auto same = [&](const TextTableColumn& other) {
      return other.group == column.group && other.header == column.header;
    };
    const std::string& name = column.group.empty() ? column.header : column.group;
    if (std::ranges::any_of(shown, same) || std::ranges::find(names, name) != names.end()) continue;
    names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string format_text_table(std::vector<TextTableColumn> columns,
                              const TerminalTextFormat& format) {
  columns = select_columns_to_fit(std::move(columns), format);
  if (columns.empty()) return "";
  const std::string gap(table_width(columns, 2) <= format.width ? 2 : 1, ' ');
  std::string head;
  if (std::ranges::any_of(columns, [](const TextTableColumn& c) { return !c.group.empty(); })) {
    head = group_header_line(columns, gap);
    if (format.colour) head = bold_line(head);
  }
  const std::string headers = header_line(columns, gap);
  std::string text = head + (format.colour ? bold_line(headers) : headers);
  for (std::size_t k = 0; k < columns.front().cells.size(); ++k) {
    text += row_line(columns, gap, k, format.colour);
  }
  return text;
}

std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent) {
  // The first line of a wrapped text keeps the leading spaces of the text.
  const std::size_t first_word = text.find_first_not_of(' ');
  std::string result, line(first_word == std::string_view::npos ? 0 : first_word, ' ');
  bool line_is_empty = true;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (!line_is_empty && line.size() + 1 + word.size() > width) {
      result += line + '\n';
      line.assign(indent, ' ');
      line_is_empty = true;
    }
    if (!line_is_empty) line += ' ';
    line += word;
    line_is_empty = false;
  }
  return result + line + '\n';
}

}  // namespace fpkcheck::report
