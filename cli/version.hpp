#pragma once

#include <string>

namespace fpkcheck::cli {

/// The text of --version: the program on the first line, then one line for each library.
std::string version_text();

}  // namespace fpkcheck::cli
