#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::check {

/// Problem of a baseline run that is solved again, and the methods of its solutions.
struct BaselineCaseToRepeat {
  problem::Problem problem;
  std::vector<methods::Method> methods;
};

/// A saved run (the baseline of a check), with the problems and methods that repeat the run.
struct CheckBaseline {
  results::Run run;  ///< saved run without the external densities
  bool has_marginals;
  std::vector<BaselineCaseToRepeat> cases;
  /// Sentences that state which quantities of the baseline are not compared, and why.
  std::vector<std::string> notes;
};

/// Reads a baseline from a directory with summary.json, or from a summary file with another name.
/// If marginals.csv exists in the same directory, the marginal densities are read from this file.
/// @param option_overrides values of options, e.g. "threads", that replace the values of the saved
///        run
/// @throws InputError with a message of one line if a file is invalid, or if a case or a solution
///         cannot be solved again
CheckBaseline load_baseline(const std::filesystem::path& path,
                            const methods::SolverRegistry& registry,
                            const base::Values& option_overrides);

/// Solves each case of a baseline run again by the methods of its solutions.
/// @param command command line, stored in the summary of the new run
results::Run repeat_baseline_run(const CheckBaseline& baseline, const std::string& command,
                                 int threads, const methods::ProgressListener& listener);

}  // namespace fpkcheck::check
