#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fpkcheck::methods {

/// Columns of numbers from an external text file. Semicolons, tabs, commas or blanks separate the
/// fields of a line. Lines that start with # are comments. The first line, also as a comment, may
/// contain column names.
struct NumberTable {
  std::string source;              ///< name of the file, for messages
  std::vector<std::string> names;  ///< column names, in lower case, without units; may be empty
  std::vector<std::vector<double>> rows;  ///< finite numbers; all rows have the same length
  std::vector<int> lines;                 ///< line number of each row, from 1

  /// Number of columns.
  std::size_t columns() const { return rows.front().size(); }
  /// The numbers of column c.
  std::vector<double> column(std::size_t c) const;
  /// Refuses the table because of a problem in a row.
  /// @throws InputError with the message "SOURCE:LINE: problem"
  [[noreturn]] void fail(std::size_t row, const std::string& problem) const;
};

/// Limit of the magnitude of abscissae, densities and integrals. With this limit, fourth powers
/// divided by the narrowest bin width are finite.
inline constexpr double kMaxMagnitude = 1e60;

/// Reads columns of numbers.
/// @param source name of the file, for messages
/// @throws InputError with a message of one line: source, line number and problem
NumberTable read_number_table(std::istream& in, const std::string& source);

}  // namespace fpkcheck::methods
