#pragma once

#include <string>
#include <vector>

namespace fpkcheck::results {

/// A joint density that others wrote as netCDF-4: a variable over two coordinates. Their names, as
/// they stand in the file, say which is which.
struct PlainJoint {
  std::string name;                     ///< of the variable
  std::string first_name, second_name;  ///< of its coordinates
  std::vector<double> first, second;    ///< values of the coordinates
  std::vector<double> values;           ///< row-major, shape (first, second)
};

/// Reads the one variable over two dimensions of which both have coordinates: variables of their
/// names.
/// @param bytes of the file
/// @param where how messages name it
/// @throws InputError on one line: broken, no such variable, or several
PlainJoint read_plain_joint(std::string bytes, const std::string& where);

}  // namespace fpkcheck::results
