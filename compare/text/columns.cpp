#include "compare/text/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace fpkcheck::compare {
namespace {

std::size_t total_width(const std::vector<Column>& shown_columns, std::size_t gap) {
  std::size_t total = 0;
  for (const auto& column : shown_columns) total += column.width() + gap;
  return total - std::min(total, gap);
}

void drop_until_it_fits(std::vector<Column>& all, std::size_t width) {
  while (total_width(all, 1) > width) {
    const int least = std::ranges::min_element(all, {}, &Column::importance)->importance;
    if (least == kAlwaysShown) return;
    std::erase_if(all, [&](const Column& column) { return column.importance == least; });
  }
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string group_line(const std::vector<Column>& all, const std::string& gap) {
  std::string line;
  for (std::size_t c = 0; c < all.size();) {
    std::size_t span = all[c].width(), next = c + 1;
    for (; next < all.size() && !all[c].group.empty() && all[next].group == all[c].group; ++next) {
      span += gap.size() + all[next].width();
    }
    const std::string text = all[c].group.empty() ? "" : ' ' + all[c].group + ' ';
    line += fmt::format(fmt::runtime(text.empty() ? "{: ^{}}" : "{:-^{}}"), text, span) + gap;
    c = next;
  }
  return without_trailing_spaces(line);
}

std::string row(const std::vector<Column>& all, const std::string& gap,
                const std::function<const std::string&(const Column&)>& text_of) {
  std::string line;
  for (const auto& column : all) {
    line += column.left_aligned ? fmt::format("{:<{}}", text_of(column), column.width())
                                : fmt::format("{:>{}}", text_of(column), column.width());
    line += gap;
  }
  return without_trailing_spaces(line);
}

}  // namespace

std::size_t Column::width() const {
  std::size_t width = header.size();
  for (const auto& cell : cells) width = std::max(width, cell.size());
  return width;
}

std::string rows(std::vector<Column> columns, std::size_t width) {
  drop_until_it_fits(columns, width);
  if (columns.empty()) return "";
  const std::string gap(total_width(columns, 2) <= width ? 2 : 1, ' ');
  std::string text;
  if (std::ranges::any_of(columns, [](const Column& c) { return !c.group.empty(); })) {
    text += group_line(columns, gap);
  }
  text += row(columns, gap, [](const Column& c) -> const std::string& { return c.header; });
  for (std::size_t k = 0; k < columns.front().cells.size(); ++k) {
    text += row(columns, gap, [k](const Column& c) -> const std::string& { return c.cells[k]; });
  }
  return text;
}

}  // namespace fpkcheck::compare
