#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::results {

/// The first bytes of a netCDF-4 file, the only supported format: the signature of HDF5.
inline constexpr std::string_view kNetCdfMagic = "\x89HDF\r\n\x1a\n";

/// Reader of a netCDF-4 file in memory. Every member throws std::runtime_error with a message of
/// one line if the file is corrupt or lacks the requested variable or attribute.
class NetCdfReader {
 public:
  explicit NetCdfReader(std::string bytes);
  NetCdfReader(const NetCdfReader&) = delete;
  NetCdfReader& operator=(const NetCdfReader&) = delete;
  ~NetCdfReader();

  /// Names of all variables, in the order in which they were written.
  std::vector<std::string> variable_names() const;
  /// Names of the dimensions of a variable.
  std::vector<std::string> dimension_names(const std::string& variable) const;
  /// Lengths of the dimensions of a variable.
  std::vector<std::size_t> dimension_lengths(const std::string& variable) const;
  /// The values of a variable as numbers, row-major.
  std::vector<double> read_values(const std::string& variable);
  /// The texts that NetCdfWriter::write_labels wrote.
  std::vector<std::string> read_labels(const std::string& variable);
  /// The edges of the cells of a coordinate, from the CF variable of cell bounds.
  std::vector<double> read_cell_edges(const std::string& coordinate);
  /// The text of an attribute of a variable.
  std::string text_attribute(const std::string& variable, const std::string& attribute) const;

 private:
  /// The number of values of a variable. This function is called before memory is allocated for the
  /// values.
  /// @throws std::runtime_error for more values than any file of this program has, and for types
  ///         other than float, double and char
  std::size_t value_count(const std::string& name);
  int variable_id(const std::string& name) const;
  std::vector<int> dimension_ids(const std::string& variable) const;

  std::string bytes_;                 // contents of the file
  std::size_t requested_values_ = 0;  // number of values requested so far
  int id_ = 0;                        // id of the open file in libnetcdf
};

}  // namespace fpkcheck::results
