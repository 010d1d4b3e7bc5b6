#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::check {

/// A case of the baseline to solve again: its problem and the methods of its solutions.
struct RepeatedCase {
  problem::Problem problem;
  std::vector<methods::Method> methods;
};

/// A saved run, and the methods that repeat it.
struct Baseline {
  results::Run run;  ///< without the solutions of external densities
  bool has_marginals;
  std::vector<RepeatedCase> cases;
  std::vector<std::string> notes;  ///< what is not compared and why: one sentence each
};

/// Reads a baseline: a directory with summary.json, or the path of such a file under any name. The
/// marginal densities come from marginals.csv in the same directory, where that file exists.
/// @param option_overrides values of options that replace those of the run, e.g.
///        "threads"; a method ignores options that it does not have
/// @throws InputError with a message of one line: as results::load_summary and load_curves; when a
///         case or a solution cannot be solved again
Baseline load_baseline(const std::filesystem::path& path, const methods::Registry& registry,
                       const base::Values& option_overrides);

/// Solves the cases of the baseline again, each by its own methods.
/// @param command the command line, for the summary
results::Run repeat_run(const Baseline& baseline, const std::string& command, int threads,
                        const methods::ProgressListener& listener);

}  // namespace fpkcheck::check
