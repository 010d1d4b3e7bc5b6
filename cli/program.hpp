#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Exit codes of all commands.
enum ExitCode {
  kSuccess = 0,
  kFailure = 1,        ///< a solver failed or missed the requested accuracy, or a check failed
  kBadInput = 2,       ///< bad input or usage; nothing was solved
  kInterrupted = 130,  ///< after SIGINT (Ctrl-C)
  kTerminated = 143    ///< after SIGTERM
};

/// Exit code of the program after a signal, by the convention of shells.
constexpr int signal_exit_code(int signal) { return 128 + signal; }

/// Runs the program. Results go to standard output, messages and progress to standard error.
/// @param arguments command line without the name of the program
/// @return an ExitCode
int run_program(const std::vector<std::string>& arguments);
/// Runs the program with the methods of a registry instead of the built-in methods.
int run_program(const std::vector<std::string>& arguments, const methods::Registry& registry);

}  // namespace fpkcheck::cli
