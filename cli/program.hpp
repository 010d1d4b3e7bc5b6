#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Exit codes of every command.
enum ExitCode {
  kDone = 0,
  kNotReached = 1,     ///< ran, but a solver did not reach what was asked, or a check failed
  kBadInput = 2,       ///< bad input or usage; nothing was solved
  kInterrupted = 130,  ///< by Ctrl-C
  kTerminated = 143    ///< by SIGTERM
};

/// The exit code of a program that a signal stopped, as a shell would say it.
constexpr int stopped_exit_code(int signal) { return 128 + signal; }

/// Runs the command that `arguments` (without the program's name) ask for. Results go to standard
/// output, messages and progress to standard error.
/// @return an ExitCode
int run_program(const std::vector<std::string>& arguments);
/// With other methods than the built-in ones.
int run_program(const std::vector<std::string>& arguments, const methods::Registry& registry);

}  // namespace fpkcheck::cli
