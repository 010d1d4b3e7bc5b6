#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "methods/method_interface.hpp"
#include "report/report_supplement.hpp"
#include "report/write_report.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {

/// Solutions whose status must be `ok` for the exit code 0.
enum class SolutionsRequiredForSuccess {
  all,
  references  ///< finite-volume solutions with the exact impact condition, and simulations
};

/// Additional output that a command such as `paper` adds to the report of a complete run.
struct RunSupplement {
  report::ReportSupplement report;
  std::string json;  ///< JSON text that the command prints instead of the summary
  /// Reasons for a nonzero exit code of a command, each in one line.
  std::vector<std::string> failures;
};

struct SolveAndReportOptions {
  SolutionsRequiredForSuccess required = SolutionsRequiredForSuccess::all;
  /// Ids of those solutions that the user requested by id instead of family or solver. Only
  /// solutions that were requested by family or solver may have the status `not_offered` without a
  /// failure of the command. If all solutions were requested by id, the list `requested_ids` is
  /// empty.
  std::vector<std::string> requested_ids = {};
  int threads = 0;  ///< number of threads for methods in parallel; 0 for one thread per processor
  InterruptionPolicy interruption_policy = InterruptionPolicy::abort;
  bool with_backward = false;  ///< whether to compute guaranteed bounds and moment error estimates
  /// Optional function that returns the additional output of the command for the completed run.
  std::function<RunSupplement(const results::Run&)> supplement = {};
};

/// Solves all cases by all given methods and prints the results as a table or JSON. With the option
/// --out, the report is written to a directory, which is prepared before the first solve.
/// @return an ExitCode
int solve_and_report(const CommonCommandArguments& common,
                     const std::vector<methods::Method>& methods,
                     const SolveAndReportOptions& options, const std::string& command_line);

}  // namespace fpkcheck::cli
