#pragma once

#include <string>

namespace fpkcheck::cli {

/// What --version prints: the program on the first line, then the libraries that it is made of, one
/// on each.
std::string version_text();

}  // namespace fpkcheck::cli
