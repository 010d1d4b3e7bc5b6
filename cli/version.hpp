#pragma once

#include <string>

namespace fpkcheck::cli {

/// Text of --version: the version of the program on the first line, then one line for each library.
std::string version_text();

}  // namespace fpkcheck::cli
