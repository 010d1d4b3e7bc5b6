#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::report {

struct TerminalTextFormat {
  // The constructor of TerminalTextFormat is not explicit, since most callers set only the text
  // width.
  TerminalTextFormat(std::size_t characters = 100, bool with_colour = false)  // NOLINT
      : width(characters), colour(with_colour) {}

  std::size_t width;
  bool colour;  ///< whether to use ANSI colours, for a terminal that supports them
};

/// Breaks a text between words into lines of at most `width` characters, each ended by a newline.
/// All lines of a wrapped text after the first line begin with `indent` spaces. A word longer than
/// a line is not broken.
std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent = 0);

inline constexpr const char* kMissingCell = "-";

struct TextTableColumn {
  std::string group;  ///< common header above neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< importance of the column; columns of equal importance are omitted together
  std::vector<std::string> cells = {};
  /// Whether the cells of the column are names of statuses, each shown in the colour of its status.
  bool is_status = false;

  std::size_t column_width() const;
};

/// Importance of a table column that is never omitted.
inline constexpr int kAlwaysShown = std::numeric_limits<int>::max();

TextTableColumn make_status_column();

/// Appends a row to a text table, with one cell for each column.
void add_table_row(std::vector<TextTableColumn>& columns, const std::vector<std::string>& cells);

/// Returns the table columns that fit into the width of the text format. If a text table is too
/// wide, its least important columns are omitted first.
std::vector<TextTableColumn> select_columns_to_fit(std::vector<TextTableColumn> columns,
                                                   const TerminalTextFormat& format);

/// Returns the names of the omitted columns, which are in `all` but not in `shown`: "L1 to fd-kf,
/// energy". If no column is omitted, the returned text is empty.
std::string omitted_column_names(const std::vector<TextTableColumn>& all,
                                 const std::vector<TextTableColumn>& shown);

/// Returns the text of a table with column headers and one line for each row. If a text table
/// exceeds the text width, its least important columns are omitted.
std::string format_text_table(std::vector<TextTableColumn> columns,
                              const TerminalTextFormat& format);

}  // namespace fpkcheck::report
