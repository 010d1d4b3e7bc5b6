#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// Name and version of the libraries that write files: as loaded, where they say it themselves.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::results
