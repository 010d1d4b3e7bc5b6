#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/text/format.hpp"

namespace fpkcheck::report {

/// What stands for a value that is absent.
inline constexpr const char* kAbsent = "-";

/// A column of a plain-text table.
struct Column {
  std::string group;  ///< stands over neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< columns of equal importance come and go together
  std::vector<std::string> cells = {};
  /// Cells are statuses: in colour, by what they mean.
  bool is_status = false;

  std::size_t width() const;
};

/// The importance of a column that is never left out.
inline constexpr int kAlwaysShown = std::numeric_limits<int>::max();

/// The column of a table that holds the solutions' statuses.
Column status_column();

/// The columns that are shown: where all do not fit into the width, the least important ones go.
std::vector<Column> fitting(std::vector<Column> columns, const TextFormat& format);

/// What was left out of `all`, for a sentence: "L1 to fd-kf, energy"; empty where nothing was.
std::string left_out(const std::vector<Column>& all, const std::vector<Column>& shown);

/// The columns side by side under their headers, one line per row. Where they do not fit into the
/// width, the least important ones go.
std::string rows(std::vector<Column> columns, const TextFormat& format);

}  // namespace fpkcheck::report
