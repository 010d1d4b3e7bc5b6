#pragma once

#include <span>
#include <string>
#include <vector>

namespace fpkcheck::results {

/// Writes a netCDF-4 file in memory, since HDF5 does not recover from a full disk, and netCDF
/// interprets some file names as network addresses. Readers list the variables in the order of
/// their names. Every member throws std::runtime_error on one line.
class NetCdfWriter {
 public:
  static constexpr int kGlobal = -1;  ///< in place of a variable's id: attributes of the file

  NetCdfWriter();
  NetCdfWriter(const NetCdfWriter&) = delete;
  NetCdfWriter& operator=(const NetCdfWriter&) = delete;
  ~NetCdfWriter();

  /// Defines a dimension.
  /// @return its id
  int dimension(const std::string& name, std::size_t length);

  /// Writes a variable of double precision; values are row-major, units are "1".
  /// @param long_name empty for the bounds of a coordinate, which have no attributes
  /// @return its id
  int variable(const std::string& name, const std::vector<int>& dimensions,
               const std::string& long_name, std::span<const double> values);

  /// Writes a coordinate of cells and its dimension, both called `name`. The values are the
  /// centres; the edges are the bounds, `name`_bounds.
  /// @param bounds the id of a dimension of length 2
  /// @return the id of the dimension
  int cells(const std::string& name, const std::string& long_name, int bounds,
            std::span<const double> edges);

  /// Writes a deflated variable of single precision, in chunks of one element of the first
  /// dimension. NaN is the fill value; units are "1".
  /// @return its id
  int compressed_float(const std::string& name, const std::vector<int>& dimensions,
                       const std::string& long_name, std::span<const float> values);

  /// Writes a deflated variable of double precision. NaN is the fill value; units are "1".
  /// @return its id
  int compressed_double(const std::string& name, const std::vector<int>& dimensions,
                        const std::string& long_name, std::span<const double> values);

  /// Writes texts along a dimension as UTF-8 characters, padded with zeros. All readers support
  /// this form.
  void labels(const std::string& name, int dimension, std::span<const std::string> texts);

  /// Writes an attribute of a variable, or of the file.
  void attribute(const std::string& name, const std::string& text, int variable = kGlobal);
  void attribute(const std::string& name, double value, int variable = kGlobal);
  void attribute(const std::string& name, int value, int variable = kGlobal);

  /// Closes the file and returns its bytes. No member may be called afterwards.
  std::string bytes();

 private:
  int id_ = 0;
  bool open_ = true;
};

}  // namespace fpkcheck::results
