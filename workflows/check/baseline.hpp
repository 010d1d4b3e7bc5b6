#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::check {

/// Case of the baseline that is solved again, and the methods of its solutions.
struct CaseToRepeat {
  problem::Problem problem;
  std::vector<methods::Method> methods;
};

/// A saved run, and the problems and methods that are needed to repeat the run.
struct Baseline {
  results::Run run;  ///< saved run without the external densities
  bool has_marginals;
  std::vector<CaseToRepeat> cases;
  /// Sentences that state which quantities are not compared, and why.
  std::vector<std::string> notes;
};

/// Reads a baseline from a directory with summary.json, or from a summary file with another name.
/// If marginals.csv exists in the same directory, the marginal densities are read from this file.
/// @param option_overrides values of options, e.g. "threads", that replace the values of the saved
///        run
/// @throws InputError with a message of one line if a file is invalid, or if a case or a solution
///         cannot be solved again
Baseline load_baseline(const std::filesystem::path& path, const methods::SolverRegistry& registry,
                       const base::Values& option_overrides);

/// Solves each case of the baseline again by the methods of its solutions.
/// @param command command line, stored in the summary of the new run
results::Run repeat_run(const Baseline& baseline, const std::string& command, int threads,
                        const methods::ProgressListener& listener);

}  // namespace fpkcheck::check
