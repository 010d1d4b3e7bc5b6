#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Name and version of each library that solves linear systems or steps in time. A version is that
/// of the loaded shared library if the library has a function that returns its version, else that
/// of the headers.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::fd_fpk
