#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// Arguments of the call of a command, and the registry of its methods.
struct CommandCall {
  std::vector<std::string> arguments;  ///< arguments after the name of the command
  std::string command_line;            ///< the whole line, for summary.json
  const methods::Registry& registry;
};

/// Functions that run the commands; each function is in the source file with the function's name.
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int run_command(const CommandCall& call);
int paper_command(const CommandCall& call);
int bounds_command(const CommandCall& call);
int reference_command(const CommandCall& call);
int study_command(const CommandCall& call);
int sweep_command(const CommandCall& call);
int advise_command(const CommandCall& call);
int check_command(const CommandCall& call);
int report_command(const CommandCall& call);
int evaluate_command(const CommandCall& call);

/// Runs the command of a solver: solves the cases by this solver alone, with the options in the
/// description of the solver.
int solver_command(const CommandCall& call, const methods::Solver& solver);
/// Runs the command `fd`, which also computes densities over time.
int fd_command(const CommandCall& call, const methods::Solver& solver);
/// Runs the command `mcs`, which can be interrupted and resumed, and can use MPI.
int mcs_command(const CommandCall& call, const methods::Solver& solver);

}  // namespace fpkcheck::cli
