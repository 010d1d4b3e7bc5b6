#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>
#include <vector>

namespace fpkcheck::cli {

/// An option, as help shows it.
struct OptionHelp {
  std::string name;              ///< "--order"
  std::string short_name = {};   ///< "-q"; may be empty
  std::string placeholder = {};  ///< "N"; empty for a switch
  std::string usual = {};        ///< its value where it is not given; may be empty
  std::string text = {};
};

/// What --help of a command shows.
struct Help {
  std::string usage;  ///< the head: how to call it, what it does, examples
  std::vector<OptionHelp> options;
};

/// A command with its help.
struct CommandHelp {
  std::string name;     ///< "run", "study grid"
  std::string summary;  ///< a line
  Help help;
};

/// The head alone: what is longer than the width is filled anew, and what is set out in columns
/// stays in them. A word that is longer than a line stays whole.
std::string usage_text(const std::string& usage, std::size_t width);

std::string help_text(const Help& help, std::size_t width);

/// What a command calls when it is asked for help: prints it in the terminal's width (80 where
/// there is no terminal), or hands it over to help_from.
void answer_help(const std::string& usage,
                 const boost::program_options::options_description& options);

/// The help that a call of a command answers with, instead of printing it.
Help help_from(const std::function<void()>& call);

}  // namespace fpkcheck::cli
