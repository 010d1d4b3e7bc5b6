#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::check {

/// A case of the baseline that is solved again: the problem, and the methods of the solutions.
struct RepeatedCase {
  problem::Problem problem;
  std::vector<methods::Method> methods;
};

/// A saved run, and the problems and methods that repeat the run.
struct Baseline {
  results::Run run;  ///< without the solutions of external densities
  bool has_marginals;
  std::vector<RepeatedCase> cases;
  std::vector<std::string> notes;  ///< what is not compared and why: one sentence each
};

/// Reads a baseline from a directory with summary.json, or from a file with the same content under
/// any name. The marginal densities come from marginals.csv in the same directory, if this file
/// exists.
/// @param option_overrides values of options, e.g. "threads", that replace the option values of the
///        saved run; a method ignores options of other methods
/// @throws InputError with a message of one line: in the cases of results::load_summary and
///         load_curves; also if a case or a solution cannot be solved again
Baseline load_baseline(const std::filesystem::path& path, const methods::Registry& registry,
                       const base::Values& option_overrides);

/// Solves each case of the baseline again by the methods that the baseline has for the case.
/// @param command command line, stored in the summary of the new run
results::Run repeat_run(const Baseline& baseline, const std::string& command, int threads,
                        const methods::ProgressListener& listener);

}  // namespace fpkcheck::check
