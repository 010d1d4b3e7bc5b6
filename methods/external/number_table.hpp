#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fpkcheck::methods {

/// Columns of numbers from an external text file. The fields of a line are separated by semicolons,
/// tabs, commas or blanks. Lines that begin with # are comments. The first line, or the last comment
/// before the numbers, may have column names.
struct NumberTable {
  std::string source;              ///< name of the file, for messages
  std::vector<std::string> names;  ///< column names in lower case without units; may be empty
  std::vector<std::vector<double>> rows;  ///< rows of finite numbers; all rows have the same length
  std::vector<int> lines;                 ///< line number of each row, from 1

  std::size_t columns() const { return rows.front().size(); }
  std::vector<double> column(std::size_t c) const;
  /// @throws InputError with the message "SOURCE:LINE: problem"
  [[noreturn]] void throw_row_error(std::size_t row, const std::string& problem) const;
};

/// Largest accepted magnitude of abscissae, densities and integrals, for which fourth powers
/// divided by the narrowest bin width are finite.
inline constexpr double kMaxMagnitude = 1e60;

/// @param source name of the file, for messages
/// @throws InputError with a message of one line that has the source and the line number
NumberTable read_number_table(std::istream& in, const std::string& source);

}  // namespace fpkcheck::methods
