#pragma once

#include <string>
#include <vector>

#include "cli/help.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// What the shell is told instead of a word: names of files, or of directories, may stand here too.
inline constexpr const char* kFiles = ":files";
inline constexpr const char* kDirectories = ":directories";

/// What the last of the words may become. Cases, commands, options, methods and the words that an
/// option takes are those of the program's own tables.
/// @param words what follows the program's name, up to the cursor; the last may be empty
std::vector<std::string> completions(const std::vector<CommandHelp>& commands,
                                     const methods::Registry& registry,
                                     const std::vector<std::string>& words);

}  // namespace fpkcheck::cli
