#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

struct OptionHelp {
  std::string name;             ///< name with dashes, e.g. "--order"
  std::string short_name = {};  ///< one-letter name, e.g. "-q"; may be empty
  /// Placeholder of the option value, e.g. "N"; empty for an option without a value.
  std::string placeholder = {};
  std::string default_value = {};  ///< default value as text; may be empty
  std::string text = {};
};

struct CommandHelpText {
  std::string usage;  ///< synopsis, description and examples of the command
  std::vector<OptionHelp> options;
};

struct CommandHelp {
  std::string name;     ///< name of the command, e.g. "run" or "study grid"
  std::string summary;  ///< description of the command in one line
  CommandHelpText help;
};

/// Wraps a usage text to lines of `width` characters. Aligned lists, and text blocks that fit into
/// the line width, are not wrapped again. A word longer than the line width is not broken.
std::string wrap_usage(const std::string& usage, std::size_t width);

/// Returns the help of a command as text: the usage, then the options in two columns.
std::string help_text(const CommandHelpText& help, std::size_t width);

/// Prints the help of a command in the width of the terminal, or in 80 columns if the output is not
/// a terminal. During a call of capture_help(), the help of a command is stored and not printed.
void print_or_capture_help(const std::string& usage,
                           const boost::program_options::options_description& options);

/// Returns, without printing, the help of a command.
/// @param call function that calls the command with the argument --help
CommandHelpText capture_help(const std::function<void()>& call);

/// Returns the man page fpkcheck(1) of all commands in troff, with the macros of man(7).
std::string manual_page(const std::vector<CommandHelp>& commands);

/// Completion candidates which the shell's completion script replaces by the names of files or of
/// directories.
inline constexpr const char* kFileNamesCandidate = ":files";
inline constexpr const char* kDirectoryNamesCandidate = ":directories";

/// Returns the completion candidates for the last word of a command line.
/// @param words words after the name of the program, up to the cursor; the last word may be empty
std::vector<std::string> completion_candidates(const std::vector<CommandHelp>& commands,
                                               const methods::SolverRegistry& registry,
                                               const std::vector<std::string>& words);

}  // namespace fpkcheck::cli
