#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/text/format.hpp"

namespace fpkcheck::report {

/// Text of a cell without a value.
inline constexpr const char* kAbsent = "-";

/// A column of a plain-text table.
struct TextColumn {
  std::string group;  ///< common header above neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< columns of equal importance are omitted together
  std::vector<std::string> cells = {};
  /// Whether the cells are names of statuses, which have the colour of the status.
  bool is_status = false;

  std::size_t width() const;
};

/// The importance value of a column that is never omitted.
inline constexpr int kAlwaysShown = std::numeric_limits<int>::max();

/// An empty column for the statuses of solutions.
TextColumn status_column();

/// The columns that fit into the width of the format: if all columns exceed the width, the least
/// important columns are omitted.
std::vector<TextColumn> fit_columns(std::vector<TextColumn> columns, const TextFormat& format);

/// The names of the columns of `all` that are not in `shown`, in one text: "L1 to fd-kf, energy".
/// The text is empty if no column of a table is omitted.
std::string omitted_columns(const std::vector<TextColumn>& all,
                            const std::vector<TextColumn>& shown);

/// The text of a table: the columns side by side under their headers, with one line for each row.
/// If the columns exceed the width, the least important columns are omitted.
std::string table_rows_text(std::vector<TextColumn> columns, const TextFormat& format);

}  // namespace fpkcheck::report
