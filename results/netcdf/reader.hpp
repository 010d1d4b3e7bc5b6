#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fpkcheck::results {

/// A netCDF file being read. Every member throws std::runtime_error on one line where the file is
/// broken or lacks what is asked for.
class NetCdfReader {
 public:
  explicit NetCdfReader(const std::filesystem::path& path);
  NetCdfReader(const NetCdfReader&) = delete;
  NetCdfReader& operator=(const NetCdfReader&) = delete;
  ~NetCdfReader();

  /// Names of all variables, in the order they were written.
  std::vector<std::string> variables() const;
  std::vector<std::string> dimensions(const std::string& variable) const;
  std::vector<std::size_t> shape(const std::string& variable) const;
  /// Row by row.
  std::vector<double> values(const std::string& variable) const;
  /// What NetCdfWriter::labels wrote.
  std::vector<std::string> labels(const std::string& variable) const;
  /// The edges of a coordinate of cells, from its bounds.
  std::vector<double> edges(const std::string& coordinate) const;
  /// An attribute of a variable.
  std::string text(const std::string& variable, const std::string& attribute) const;

 private:
  int variable(const std::string& name) const;
  std::vector<int> dimension_ids(const std::string& variable) const;

  int id_ = 0;
};

}  // namespace fpkcheck::results
