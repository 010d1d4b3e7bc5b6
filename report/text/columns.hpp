#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/text/format.hpp"

namespace fpkcheck::report {

/// Text of a cell without a value.
inline constexpr const char* kAbsent = "-";

/// A column of a plain-text table.
struct Column {
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
Column status_column();

/// The columns that fit into the width of the format: if all columns exceed the width, the least
/// important columns are omitted.
std::vector<Column> fit_columns(std::vector<Column> columns, const TextFormat& format);

/// The names of the columns of `all` that are not in `shown`, in one text: "L1 to fd-kf, energy".
/// The text is empty if no column of a table is omitted.
std::string omitted_columns(const std::vector<Column>& all, const std::vector<Column>& shown);

/// The text of a table: the columns side by side under their headers, with one line for each row.
/// If the columns exceed the width, the least important columns are omitted.
std::string rows(std::vector<Column> columns, const TextFormat& format);

}  // namespace fpkcheck::report
