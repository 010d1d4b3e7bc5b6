#pragma once

#include <string>
#include <vector>

namespace fpkcheck::cli {

/// One function per command, each in a file of its name.
/// @param arguments what follows the command's name
/// @param command_line the whole line, for summary.json
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int run_command(const std::vector<std::string>& arguments, const std::string& command_line);
int epc_command(const std::vector<std::string>& arguments, const std::string& command_line);
int fd_command(const std::vector<std::string>& arguments, const std::string& command_line);
int mcs_command(const std::vector<std::string>& arguments, const std::string& command_line);
int reference_command(const std::vector<std::string>& arguments, const std::string& command_line);
int study_command(const std::vector<std::string>& arguments, const std::string& command_line);
int check_command(const std::vector<std::string>& arguments, const std::string& command_line);
int report_command(const std::vector<std::string>& arguments, const std::string& command_line);

}  // namespace fpkcheck::cli
