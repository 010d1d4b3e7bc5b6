#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "results/run.hpp"

namespace fpkcheck::check {

/// What to solve again of one case.
struct CaseAgain {
  problem::Problem problem;
  std::vector<methods::Method> methods;
};

/// A saved run, and how to repeat it.
struct Baseline {
  results::Run run;  ///< without the solutions that were read from files
  bool has_marginals;
  std::vector<CaseAgain> cases;
  std::vector<std::string> notes;  ///< what is not compared and why, one sentence each
};

/// Reads a baseline: a summary.json under any name, with the marginals.csv beside it where there is
/// one, or the directory that holds them.
/// @param given options that replace those of the run for all methods that know them, e.g.
///        "threads"
/// @throws InputError on one line: as results::load_summary and load_curves do; when a case or a
///         solution cannot be solved again
Baseline load_baseline(const std::filesystem::path& place, const methods::Registry& registry,
                       const base::Values& given);

/// Solves again what the baseline holds.
/// @param command the command line, for the summary
results::Run run_again(const Baseline& baseline, const std::string& command, int threads,
                       const methods::ProgressListener& listener);

}  // namespace fpkcheck::check
