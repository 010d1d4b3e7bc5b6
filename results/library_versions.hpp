#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// Names and versions of the libraries that write files. For netCDF, the version of the loaded
/// library; for nlohmann-json, the version of the headers that the program was compiled with.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
