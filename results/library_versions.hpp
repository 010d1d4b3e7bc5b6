#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// Name and version of the libraries that write files: the loaded version of netCDF, the compiled
/// version of nlohmann-json.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
