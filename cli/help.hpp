#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Help text of an option, in parts.
struct OptionHelp {
  std::string name;                ///< "--order"
  std::string short_name = {};     ///< "-q"; may be empty
  std::string placeholder = {};    ///< "N"; empty for a switch
  std::string default_value = {};  ///< default of the option as text; may be empty
  std::string text = {};
};

/// Help of a command, as printed by --help.
struct Help {
  std::string usage;  ///< synopsis, description and examples
  std::vector<OptionHelp> options;
};

/// Name, summary and help of a command.
struct CommandHelp {
  std::string name;     ///< "run", "study grid"
  std::string summary;  ///< description in one line
  Help help;
};

/// Wraps a usage text to `width` columns: paragraphs are refilled, the columns of lists are
/// preserved, and blocks that fit are unchanged. A word longer than a line is not broken.
std::string wrap_usage(const std::string& usage, std::size_t width);

/// Help of a command as text: the usage, then the options with their descriptions in a column.
std::string help_text(const Help& help, std::size_t width);

/// Prints the help of a command in the width of the terminal (80 columns without a terminal), or
/// passes the help to capture_help(). Every command calls emit_help for the option --help.
void emit_help(const std::string& usage,
               const boost::program_options::options_description& options);

/// Help that a call of a command with --help would print.
/// @param call function that calls a command with --help
Help capture_help(const std::function<void()>& call);

/// Text of the man page fpkcheck(1) of all commands and options, in troff with the macros of
/// man(7).
std::string manual_page(const std::vector<CommandHelp>& commands);

/// Candidates that the completion script replaces by all file names or all directory names.
inline constexpr const char* kFileNamesCandidate = ":files";
inline constexpr const char* kDirectoryNamesCandidate = ":directories";

/// Completion candidates for the last word of a command line. The program's own tables supply the
/// commands, options, cases, methods and choices.
/// @param words words after the program's name, up to the cursor; the last word may be empty
std::vector<std::string> completion_candidates(const std::vector<CommandHelp>& commands,
                                               const methods::Registry& registry,
                                               const std::vector<std::string>& words);

}  // namespace fpkcheck::cli
