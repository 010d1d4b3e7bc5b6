#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Name and version of each library that solves linear systems or steps in time. Versions are those
/// of the loaded shared library where the library has a query function, else those of the headers.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::fd_fpk
