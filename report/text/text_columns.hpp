#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/text/text_format.hpp"

namespace fpkcheck::report {

inline constexpr const char* kMissingCell = "-";

struct TextColumn {
  std::string group;  ///< common header above neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< importance of the column; columns of equal importance are omitted together
  std::vector<std::string> cells = {};
  /// Whether the cells are names of statuses, which are shown in the colour of the status.
  bool is_status = false;

  std::size_t width() const;
};

/// Importance of a column that is never omitted.
inline constexpr int kAlwaysShown = std::numeric_limits<int>::max();

TextColumn make_status_column();

/// Returns the columns that fit into the width of the format. The least important columns are
/// omitted first.
std::vector<TextColumn> select_columns_to_fit(std::vector<TextColumn> columns,
                                              const TextFormat& format);

/// Returns the names of the columns of `all` that are not in `shown`: "L1 to fd-kf, energy". The
/// text is empty if no column is omitted.
std::string omitted_column_names(const std::vector<TextColumn>& all,
                                 const std::vector<TextColumn>& shown);

/// Returns the text of a table with column headers and one line for each row. If the columns exceed
/// the width, the least important columns are omitted.
std::string format_text_table(std::vector<TextColumn> columns, const TextFormat& format);

}  // namespace fpkcheck::report
