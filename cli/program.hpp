#pragma once

#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::cli {

enum ExitCode {
  kSuccess = 0,
  kFailure = 1,        ///< failure of a solver or of a check, or insufficient accuracy
  kBadInput = 2,       ///< invalid input or usage, detected before any problem was solved
  kInterrupted = 130,  ///< SIGINT (Ctrl-C) stopped the program
  kTerminated = 143    ///< SIGTERM stopped the program
};

/// Returns the exit code of the program after a signal, by the convention of shells.
constexpr int signal_exit_code(int signal) { return 128 + signal; }

/// Runs the fpkcheck command that the command-line arguments name. The results of a command are
/// written to standard output, and messages and progress to standard error.
/// @param arguments command-line arguments without the name of the program
/// @return an ExitCode
int run_program(const std::vector<std::string>& arguments);
/// Runs the program with the methods of `registry` instead of the built-in methods.
int run_program(const std::vector<std::string>& arguments, const methods::SolverRegistry& registry);

struct CommandInvocation {
  std::vector<std::string> arguments;  ///< arguments after the name of the command
  std::string command_line;            ///< complete command line, stored in summary.json
  const methods::SolverRegistry& registry;
};

/// Each function NAME_command() runs the command NAME.
/// @return an ExitCode
/// @throws InputError for invalid input or usage, before anything is solved or written
int run_command(const CommandInvocation& call);
int paper_command(const CommandInvocation& call);
int bounds_command(const CommandInvocation& call);
int reference_command(const CommandInvocation& call);
int study_command(const CommandInvocation& call);
int passage_command(const CommandInvocation& call);
/// Returns whether the arguments of the command `run` contain the option --until.
bool requests_density_over_time(const CommandInvocation& call);
/// Runs the command `run --until T`, which computes densities over time.
/// @return an ExitCode
int density_over_time_command(const CommandInvocation& call);
int spectrum_command(const CommandInvocation& call);
int sensitivity_command(const CommandInvocation& call);
int sweep_command(const CommandInvocation& call);
int advise_command(const CommandInvocation& call);
int check_command(const CommandInvocation& call);
int report_command(const CommandInvocation& call);
int evaluate_command(const CommandInvocation& call);

/// Runs the command of one solver, such as `fd`, which solves the cases by this solver alone.
int solver_command(const CommandInvocation& call, const methods::Solver& solver);
int fd_command(const CommandInvocation& call, const methods::Solver& solver);
int mcs_command(const CommandInvocation& call, const methods::Solver& solver);

struct StudySubcommand {
  std::string name;
  std::string summary;  ///< description of the subject in `fpkcheck study --help`
  int (*run)(const CommandInvocation&);
};
const std::vector<StudySubcommand>& study_subjects();

}  // namespace fpkcheck::cli
