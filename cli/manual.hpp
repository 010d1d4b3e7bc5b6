#pragma once

#include <string>
#include <vector>

#include "cli/help.hpp"

namespace fpkcheck::cli {

/// The manual page fpkcheck(1), as troff with the macros of man(7): every command with its options.
std::string manual(const std::vector<CommandHelp>& commands);

}  // namespace fpkcheck::cli
