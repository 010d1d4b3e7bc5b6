#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>
#include <vector>

namespace fpkcheck::cli {

/// The help of an option.
struct OptionHelp {
  std::string name;                ///< "--order"
  std::string short_name = {};     ///< "-q"; may be empty
  std::string placeholder = {};    ///< "N"; empty for a switch
  std::string default_value = {};  ///< its default as text; may be empty
  std::string text = {};
};

/// The help of a command, as --help prints it.
struct Help {
  std::string usage;  ///< synopsis, description and examples
  std::vector<OptionHelp> options;
};

/// A command with its help.
struct CommandHelp {
  std::string name;     ///< "run", "study grid"
  std::string summary;  ///< description in one line
  Help help;
};

/// Wraps a usage text to the width: paragraphs are refilled, items keep their columns, and blocks
/// that fit are unchanged. A word longer than a line is not broken.
std::string wrap_usage(const std::string& usage, std::size_t width);

/// The help as text: the usage, then the options with their texts in a column.
std::string help_text(const Help& help, std::size_t width);

/// Prints the help of a command in the width of the terminal (80 columns without a terminal), or
/// passes the help to capture_help(). Called by a command for --help.
void emit_help(const std::string& usage,
               const boost::program_options::options_description& options);

/// The help that a call of a command would print.
/// @param call calls a command with --help
Help capture_help(const std::function<void()>& call);

}  // namespace fpkcheck::cli
