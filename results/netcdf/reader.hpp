#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::results {

/// How the files that are read begin: HDF5.
inline constexpr std::string_view kNetCdfMagic = "\x89HDF\r\n\x1a\n";

/// A netCDF file being read from memory. Every member throws std::runtime_error on one line where
/// the file is broken or lacks what is asked for.
class NetCdfReader {
 public:
  explicit NetCdfReader(std::string bytes);
  NetCdfReader(const NetCdfReader&) = delete;
  NetCdfReader& operator=(const NetCdfReader&) = delete;
  ~NetCdfReader();

  /// Names of all variables, in the order they were written.
  std::vector<std::string> variables() const;
  std::vector<std::string> dimensions(const std::string& variable) const;
  std::vector<std::size_t> shape(const std::string& variable) const;
  /// Row by row.
  std::vector<double> values(const std::string& variable);
  /// What NetCdfWriter::labels wrote.
  std::vector<std::string> labels(const std::string& variable);
  /// The edges of a coordinate of cells, from its bounds.
  std::vector<double> edges(const std::string& coordinate);
  /// An attribute of a variable.
  std::string text(const std::string& variable, const std::string& attribute) const;

 private:
  /// How many values a variable has, before any room is made for them.
  /// @throws std::runtime_error for more than any file of ours has, and for other types
  std::size_t count_of(const std::string& name);
  int variable(const std::string& name) const;
  std::vector<int> dimension_ids(const std::string& variable) const;

  std::string bytes_;          // of the file
  std::size_t asked_for_ = 0;  // values, so far
  int id_ = 0;
};

}  // namespace fpkcheck::results
