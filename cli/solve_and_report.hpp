#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "methods/method.hpp"
#include "report/report.hpp"
#include "report/supplement.hpp"
#include "report/text/format.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {

/// Which solutions must be `ok` for the exit code 0.
enum class Required {
  all,        ///< each was asked for by name
  references  ///< finite differences and simulation: how far the closures and the first-order
              ///< impact carry is the question
};

/// What a command makes of a run that came to its end, beside what every run leaves.
struct Supplement {
  report::Supplement report;
  std::string json;  ///< printed instead of the summary
  /// What makes the exit code other than 0, a line each.
  std::vector<std::string> failures;
};

struct SolveControl {
  Required required = Required::all;
  /// Solutions that were asked for by their own names, where others came with a family or a solver: of
  /// those it is no failure that the problem is not offered. Empty: all were.
  std::vector<std::string> named = {};
  int threads = 0;  ///< for methods side by side; 0 for one per processor
  OnInterruption on_interruption = OnInterruption::give_up;
  bool with_backward = false;  ///< bounds, and every density's own error, by the backward equation
  std::function<Supplement(const results::Run&)> supplement = {};  ///< may be none
};

/// Solves the cases by the methods, prints the table (or the JSON), and writes the report when a
/// directory was given. The directory is prepared before anything is solved.
/// @return an ExitCode
int solve_and_report(const CommonArguments& common, const std::vector<methods::Method>& methods,
                     const SolveControl& control, const std::string& command_line);

/// The terminal's width within 80 .. 100 characters, 100 when standard output is none; in colour on
/// a terminal, unless NO_COLOR is set (to anything but nothing) or TERM is "dumb".
report::TextFormat terminal_format();

}  // namespace fpkcheck::cli
