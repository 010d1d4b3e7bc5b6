#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Name and version of the libraries that solve the linear systems and step in time: as loaded,
/// where they say it themselves.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace fpkcheck::fd_fpk
