#pragma once

#include <string>
#include <vector>

#include "cli/help.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Candidates that the completion script replaces by all file names or all directory names.
inline constexpr const char* kFileNamesCandidate = ":files";
inline constexpr const char* kDirectoryNamesCandidate = ":directories";

/// Completion candidates for the last of the words. Commands, options, cases, methods and choices
/// are those of the program's own tables.
/// @param words words after the program's name, up to the cursor; the last word may be empty
std::vector<std::string> completion_candidates(const std::vector<CommandHelp>& commands,
                                               const methods::Registry& registry,
                                               const std::vector<std::string>& words);

}  // namespace fpkcheck::cli
