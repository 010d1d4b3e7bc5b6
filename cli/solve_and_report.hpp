#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/shutdown.hpp"
#include "methods/method.hpp"
#include "report/report.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {

/// Solutions that must have status `ok` for the exit code 0.
enum class RequiredSolutions {
  all,        ///< all solutions
  references  ///< finite volumes with the exact impact, and simulation. The accuracy of closures
              ///< and first-order impacts is a result of the run, not a requirement
};

/// Additional output of a command in the report of a complete run.
struct Supplement {
  report::Supplement report;
  std::string json;  ///< JSON text that is printed instead of the summary
  /// Reasons for an exit code other than 0, one line each.
  std::vector<std::string> failures;
};

struct SolveAndReportOptions {
  RequiredSolutions required = RequiredSolutions::all;
  /// Solution ids in the list of methods. A solution of a family or solver in the list, whose id is
  /// not in `requested_ids`, may have the status not_offered without a failure. Empty if all
  /// solutions were requested by id.
  std::vector<std::string> requested_ids = {};
  int threads = 0;  ///< number of threads for methods in parallel; 0: one per processor
  InterruptionPolicy interruption_policy = InterruptionPolicy::abort;
  bool with_backward = false;  ///< compute guaranteed bounds and residual-based error estimates
  std::function<Supplement(const results::Run&)> supplement = {};  ///< may be none
};

/// Solves the cases by the methods, prints the table (or the JSON), and with --out writes the
/// report. The output directory is prepared before the first solution.
/// @return an ExitCode
int solve_and_report(const CommonArguments& common, const std::vector<methods::Method>& methods,
                     const SolveAndReportOptions& control, const std::string& command_line);

}  // namespace fpkcheck::cli
