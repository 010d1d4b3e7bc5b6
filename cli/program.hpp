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

/// Arguments of the call of a command, and the registry of its methods.
struct CommandCall {
  std::vector<std::string> arguments;  ///< arguments after the name of the command
  std::string command_line;            ///< the whole line, for summary.json
  const methods::Registry& registry;
};

/// Functions that run the commands. check_command() and report_command() are in
/// cli/saved_run_commands.cpp, solver_command() is in cli/run_command.cpp; each other function is in
/// the source file with the function's name.
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

/// A subject of `fpkcheck study`.
struct StudySubject {
  std::string name;
  std::string summary;  ///< description in `fpkcheck study --help`
  int (*run)(const CommandCall&);
};
const std::vector<StudySubject>& study_subjects();

/// Functions that run the subjects of `study`.
/// @param call call of the command, with the arguments after the subject
/// @return an ExitCode
/// @throws InputError for bad input or usage, before anything is solved or written
int study_grid(const CommandCall& call);
int study_order(const CommandCall& call);
int study_regularisation(const CommandCall& call);

}  // namespace fpkcheck::cli
