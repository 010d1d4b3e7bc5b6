#pragma once

#include <string>
#include <vector>

namespace fpkcheck::results {

/// An external joint density in a netCDF-4 file: a variable with two coordinates. The names of the
/// coordinates in the file identify y and y'.
struct GriddedVariable {
  std::string name;                     ///< name of the variable
  std::string first_name, second_name;  ///< names of the coordinates
  std::vector<double> first, second;    ///< values of the coordinates
  std::vector<double> values;           ///< row-major, shape (first, second)
};

/// Reads the variable with two dimensions that both have a coordinate, a variable with the name of
/// the dimension.
/// @param bytes of the file
/// @param where the file's name in messages
/// @throws InputError on one line: a corrupt file, no such variable, or several
GriddedVariable read_gridded_variable(std::string bytes, const std::string& where);

}  // namespace fpkcheck::results
