#pragma once

#include <limits>
#include <string>
#include <vector>

namespace fpkcheck::compare {

/// What stands for a value that is absent.
inline constexpr const char* kAbsent = "-";

/// A column of a plain-text table.
struct Column {
  std::string group;  ///< stands over neighbouring columns of the same group
  std::string header;
  bool left_aligned;
  int importance;  ///< columns of equal importance come and go together
  std::vector<std::string> cells = {};

  std::size_t width() const;
};

/// The importance of a column that is never left out.
inline constexpr int kAlwaysShown = std::numeric_limits<int>::max();

/// The columns side by side under their headers, one line per row. Where they do not fit into
/// `width` characters, the least important ones go.
std::string rows(std::vector<Column> columns, std::size_t width);

}  // namespace fpkcheck::compare
