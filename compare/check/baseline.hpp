#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/methods.hpp"
#include "compare/report.hpp"
#include "compare/run_cases.hpp"

namespace fpkcheck::compare {

/// What to solve again of one case.
struct CaseAgain {
  problem::Problem problem;
  std::vector<Method> methods;
};

/// A saved run, and how to repeat it.
struct Baseline {
  SavedRun run;  ///< without the solutions that were read from files
  bool has_marginals;
  std::vector<CaseAgain> cases;
  std::vector<std::string> notes;  ///< what is not compared and why, one sentence each
};

/// Reads a baseline: a summary.json under any name, with the marginals.csv beside it where there is
/// one, or the directory that holds them.
/// @param threads to repeat it with, 0 for one per processor
/// @throws InputError on one line: as load_summary does; when a case or a solution cannot be solved
///         again; when the marginals are of another run
Baseline load_baseline(const std::filesystem::path& place, int threads);

/// Solves again what the baseline holds.
/// @param command the command line, for the summary
SavedRun run_again(const Baseline& baseline, const std::string& command, int threads,
                   const ProgressListener& listener);

}  // namespace fpkcheck::compare
