#pragma once

#include <span>
#include <string>
#include <vector>

namespace fpkcheck::results {

/// A netCDF-4 file being made, in memory: HDF5 does not survive a disk that is full, and netCDF takes
/// some names of files for addresses. Readers find its variables in the order of their names. Every
/// member throws std::runtime_error on one line.
class NetCdfWriter {
 public:
  static constexpr int kFile = -1;  ///< stands for the file where a variable is asked for

  NetCdfWriter();
  NetCdfWriter(const NetCdfWriter&) = delete;
  NetCdfWriter& operator=(const NetCdfWriter&) = delete;
  ~NetCdfWriter();

  /// @return its id
  int dimension(const std::string& name, std::size_t length);

  /// A variable of double precision with its values, row by row; its units are "1".
  /// @param long_name empty for the bounds of a coordinate, which have no attributes
  /// @return its id
  int variable(const std::string& name, const std::vector<int>& dimensions,
               const std::string& long_name, std::span<const double> values);

  /// A coordinate of cells by that name, with its dimension, at the centres; the edges are its
  /// bounds, NAME_bounds.
  /// @param bounds the id of a dimension of length 2
  /// @return the id of the dimension
  int cells(const std::string& name, const std::string& long_name, int bounds,
            std::span<const double> edges);

  /// A variable of single precision, compressed, in chunks of one element of its first dimension.
  /// NaN is its fill value; its units are "1".
  /// @return its id
  int compressed(const std::string& name, const std::vector<int>& dimensions,
                 const std::string& long_name, std::span<const float> values);

  /// A variable of double precision, compressed; NaN is its fill value, its units are "1".
  /// @return its id
  int packed(const std::string& name, const std::vector<int>& dimensions,
             const std::string& long_name, std::span<const double> values);

  /// Texts along a dimension as UTF-8 characters, padded with zeros: what every reader understands.
  void labels(const std::string& name, int dimension, std::span<const std::string> texts);

  /// Of a variable, or of the file.
  void attribute(const std::string& name, const std::string& text, int variable = kFile);
  void attribute(const std::string& name, double value, int variable = kFile);
  void attribute(const std::string& name, int value, int variable = kFile);

  /// The whole file; nothing can be added any more.
  std::string bytes();

 private:
  int id_ = 0;
  bool open_ = true;
};

}  // namespace fpkcheck::results
