#pragma once

#include <string>
#include <vector>

namespace fpkcheck::cli {

/// One function per subject of `fpkcheck study`, each in a file of its name.
/// @param arguments what follows the subject
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int study_grid(const std::vector<std::string>& arguments, const std::string& command_line);
int study_order(const std::vector<std::string>& arguments, const std::string& command_line);
int study_regularisation(const std::vector<std::string>& arguments,
                         const std::string& command_line);

}  // namespace fpkcheck::cli
