#pragma once

#include <string>
#include <vector>

#include "cli/help.hpp"

namespace fpkcheck::cli {

/// Text of the man page fpkcheck(1) of all commands and options, in troff with the macros of
/// man(7).
std::string manual_page(const std::vector<CommandHelp>& commands);

}  // namespace fpkcheck::cli
