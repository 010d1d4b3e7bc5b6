#pragma once

#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::results {

/// Writer of a netCDF-4 file in memory. Every member function throws std::runtime_error with a
/// message of one line. Writing netCDF directly to disk would be unsafe, since HDF5 does not
/// recover from a full disk, and netCDF interprets some file names as network addresses.
class NetCdfWriter {
 public:
  /// Value that replaces the id of a variable for global attributes of the netCDF file.
  static constexpr int kGlobal = -1;

  NetCdfWriter();
  NetCdfWriter(const NetCdfWriter&) = delete;
  NetCdfWriter& operator=(const NetCdfWriter&) = delete;
  ~NetCdfWriter();

  /// @return the id of the dimension
  int define_dimension(const std::string& name, std::size_t length);

  /// Writes a variable of double precision with the unit "1".
  /// @param dimensions ids of the dimensions
  /// @param long_name description of the variable; an empty text stands for CF cell bounds, which
  /// have no attributes
  /// @param values values of the variable, row-major
  /// @return the id of the variable
  int write_variable(const std::string& name, const std::vector<int>& dimensions,
                     const std::string& long_name, std::span<const double> values);

  /// Defines the dimension `name`, writes the cell centres as the coordinate variable of the
  /// dimension, and writes the cell edges as the variable `name`_bounds.
  /// @param bounds id of a dimension of length 2
  /// @return the id of the dimension
  int write_cell_coordinate(const std::string& name, const std::string& long_name, int bounds,
                            std::span<const double> edges);

  /// Writes a compressed variable of single or double precision with the unit "1" and the fill
  /// value NaN. A chunk of a single-precision variable contains the values for one index of the
  /// first dimension.
  /// @param dimensions ids of the dimensions
  /// @return the id of the variable
  template <class Number>
  int write_compressed(const std::string& name, const std::vector<int>& dimensions,
                       const std::string& long_name, std::span<const Number> values);
  /// Writes texts along a dimension as UTF-8 padded with zeros, which all netCDF readers support.
  /// @param dimension id of the dimension
  void write_labels(const std::string& name, int dimension, std::span<const std::string> texts);

  /// @param variable id of the variable that gets the attribute, or kGlobal for the file
  void write_attribute(const std::string& name, const std::string& text, int variable = kGlobal);
  void write_attribute(const std::string& name, double value, int variable = kGlobal);
  void write_attribute(const std::string& name, int value, int variable = kGlobal);

  /// Closes the netCDF file and returns the bytes of the file.
  /// @pre no other member function is called afterwards
  std::string close_and_take_bytes();

 private:
  int id_ = 0;  // id of the open file in libnetcdf
  bool open_ = true;
};

/// Writes the name and the parameters of a problem as attributes.
/// @param variable id of the variable that gets the attributes, or kGlobal for the file
void write_problem_attributes(NetCdfWriter& file, const problem::Problem& problem,
                              int variable = NetCdfWriter::kGlobal);

}  // namespace fpkcheck::results
