#pragma once

#include <string>
#include <vector>

namespace fpkcheck::results {

/// An external joint density from a netCDF-4 file: a variable with two coordinates. The names of
/// the coordinates show which coordinate is y and which is y'.
struct GriddedVariable {
  std::string name;                     ///< name of the variable
  std::string first_name, second_name;  ///< names of the coordinates
  std::vector<double> first, second;    ///< values of the coordinates
  std::vector<double> values;           ///< row-major, shape (first, second)
};

/// Reads the only variable of a netCDF-4 file that has two dimensions and a coordinate for each of
/// them. The coordinate of a dimension is the variable with the name of the dimension.
/// @param bytes contents of the file
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the file is corrupt, or has no such variable,
///         or has several
GriddedVariable read_gridded_variable(std::string bytes, const std::string& where);

}  // namespace fpkcheck::results
