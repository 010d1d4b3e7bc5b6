#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::results {

/// First bytes of a netCDF-4 file, the only supported format: the signature of HDF5.
inline constexpr std::string_view kNetCdfMagic = "\x89HDF\r\n\x1a\n";

/// Reader of a netCDF-4 file in memory. Every member function throws std::runtime_error with a
/// message of one line if the file is corrupt or lacks the requested variable or attribute.
class NetCdfReader {
 public:
  explicit NetCdfReader(std::string bytes);
  NetCdfReader(const NetCdfReader&) = delete;
  NetCdfReader& operator=(const NetCdfReader&) = delete;
  ~NetCdfReader();

  std::vector<std::string> variable_names() const;
  std::vector<std::string> dimension_names(const std::string& variable) const;
  std::vector<std::size_t> dimension_lengths(const std::string& variable) const;
  std::vector<double> read_values(const std::string& variable);
  /// Reads the texts of a variable that NetCdfWriter::write_labels wrote.
  std::vector<std::string> read_labels(const std::string& variable);
  /// Reads the cell edges of a coordinate from its CF variable of cell bounds.
  std::vector<double> read_cell_edges(const std::string& coordinate);
  std::string read_text_attribute(const std::string& variable, const std::string& attribute) const;

 private:
  /// Returns the number of values of a netCDF variable, for checks before memory is allocated.
  /// @throws std::runtime_error if the number of values exceeds the limit of the program, or if the
  /// type of the variable is not float, double or char
  std::size_t value_count(const std::string& name);
  int variable_id(const std::string& name) const;
  std::vector<int> dimension_ids(const std::string& variable) const;

  std::string bytes_;
  std::size_t requested_values_ = 0;
  int id_ = 0;  // id of the open file in libnetcdf
};

}  // namespace fpkcheck::results
