#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

/// How a command was called.
struct Call {
  std::vector<std::string> arguments;  ///< what follows the command's name
  std::string command_line;            ///< the whole line, for summary.json
  const methods::Registry& registry;
};

/// One function per command, each in a file of its name.
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int run_command(const Call& call);
int paper_command(const Call& call);
int bounds_command(const Call& call);
int reference_command(const Call& call);
int study_command(const Call& call);
int sweep_command(const Call& call);
int advise_command(const Call& call);
int check_command(const Call& call);
int report_command(const Call& call);
int evaluate_command(const Call& call);

/// The command of a solver: its cases by it alone, with the options that it describes.
int solver_command(const Call& call, const methods::Solver& solver);
/// The same for finite differences, which also have densities over time.
int fd_command(const Call& call, const methods::Solver& solver);
/// The same for the simulation, which can be interrupted and resumed.
int mcs_command(const Call& call, const methods::Solver& solver);

}  // namespace fpkcheck::cli
