#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fpkcheck::methods {

/// Columns of numbers of an external text file. Semicolons, tabs, commas or blanks separate the
/// fields. Lines that start with # are comments. The first line may contain column names, also as a
/// comment.
struct NumberTable {
  std::string source;                     ///< the file's name in messages
  std::vector<std::string> names;         ///< column names, in lower case, without units; or empty
  std::vector<std::vector<double>> rows;  ///< finite numbers; all rows have the same length
  std::vector<int> lines;                 ///< the line number of each row, from 1

  std::size_t columns() const { return rows.front().size(); }
  std::vector<double> column(std::size_t c) const;
  /// @throws InputError SOURCE:LINE: problem
  [[noreturn]] void fail(std::size_t row, const std::string& problem) const;
};

/// @throws InputError on one line: source, line number and problem
NumberTable read_number_table(std::istream& in, const std::string& source);

}  // namespace fpkcheck::methods
