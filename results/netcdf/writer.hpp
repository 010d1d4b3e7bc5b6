#pragma once

#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::results {

/// Writer of a netCDF-4 file in memory. The file is not written to disk directly, since HDF5 does
/// not recover from a full disk and netCDF interprets some file names as network addresses.
/// Programs that read the file list its variables in the order of their names. Every member throws
/// std::runtime_error with a message of one line.
class NetCdfWriter {
 public:
  /// Value in place of the id of a variable, for attributes of the file.
  static constexpr int kGlobal = -1;

  NetCdfWriter();
  NetCdfWriter(const NetCdfWriter&) = delete;
  NetCdfWriter& operator=(const NetCdfWriter&) = delete;
  ~NetCdfWriter();

  /// Defines a dimension.
  /// @return the id of the dimension
  int define_dimension(const std::string& name, std::size_t length);

  /// Writes a variable of double precision; values are row-major, units are "1".
  /// @param dimensions ids of the dimensions
  /// @param long_name description of the variable; empty for the cell bounds of a coordinate, which
  ///        have no attributes
  /// @return the id of the variable
  int write_variable(const std::string& name, const std::vector<int>& dimensions,
                     const std::string& long_name, std::span<const double> values);

  /// Writes the coordinate variable of the cells along one dimension, and defines the dimension;
  /// both have the name `name`. The values are the centres of the cells. The variable `name`_bounds
  /// contains the edges.
  /// @param bounds id of a dimension of length 2
  /// @return the id of the dimension
  int write_cell_coordinate(const std::string& name, const std::string& long_name, int bounds,
                            std::span<const double> edges);

  /// Writes a deflated variable of single or double precision. NaN is the fill value; units are "1".
  /// A variable of single precision has chunks of one element of the first dimension.
  /// @param dimensions ids of the dimensions
  /// @return the id of the variable
  template <class Number>
  int write_compressed(const std::string& name, const std::vector<int>& dimensions,
                       const std::string& long_name, std::span<const Number> values);
  /// Writes a variable of texts along a dimension, as UTF-8 characters padded with zeros. All
  /// netCDF readers support this form.
  /// @param dimension id of the dimension
  void write_labels(const std::string& name, int dimension, std::span<const std::string> texts);

  /// Writes an attribute.
  /// @param variable id of the variable that gets the attribute, or kGlobal for the file
  void write_attribute(const std::string& name, const std::string& text, int variable = kGlobal);
  void write_attribute(const std::string& name, double value, int variable = kGlobal);
  void write_attribute(const std::string& name, int value, int variable = kGlobal);

  /// Closes the file and returns its bytes. No member may be called afterwards.
  std::string close_and_take_bytes();

 private:
  int id_ = 0;        // id of the file in libnetcdf
  bool open_ = true;  // whether the file is open
};

/// Writes the parameters of a problem as netCDF attributes: `damping`, .., `impulse_rate`,
/// `impulse_law`, ..
/// @param variable id of the variable that gets the attributes, or kGlobal for the file
void write_problem_attributes(NetCdfWriter& file, const problem::Problem& problem,
                              int variable = NetCdfWriter::kGlobal);

}  // namespace fpkcheck::results
