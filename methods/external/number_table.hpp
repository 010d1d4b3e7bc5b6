#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fpkcheck::methods {

/// Columns of numbers in a text file made by others: fields separated by semicolons, tabs, commas
/// or blanks, lines that start with # left out. A line of names may come first, also as a comment.
struct NumberTable {
  std::string source;              ///< how messages name the file
  std::vector<std::string> names;  ///< of the columns, in lower case, without units; or empty
  std::vector<std::vector<double>> rows;  ///< all of the same length, finite
  std::vector<int> lines;                 ///< the line number of each row, from 1

  std::size_t columns() const { return rows.front().size(); }
  std::vector<double> column(std::size_t c) const;
  /// @throws InputError SOURCE:LINE: problem
  [[noreturn]] void fail(std::size_t row, const std::string& problem) const;
};

/// @throws InputError on one line: source, line number and what is wrong
NumberTable read_number_table(std::istream& in, const std::string& source);

}  // namespace fpkcheck::methods
