#pragma once

#include <chrono>
#include <string>

#include "cli/command_line.hpp"
#include "cli/shutdown.hpp"
#include "workflows/study/output.hpp"

namespace fpkcheck::cli {

/// Prints the table or the JSON of a study. With --out, also writes STEM.json, STEM.csv and
/// figures/STEM.gp with its figures. Ends with a line that lists the files.
void write_study(const CommonArguments& common, const study::StudyOutput& output,
                 std::chrono::steady_clock::time_point start_time);

/// The exit code of a study; with --quiet, a failure prints a line to standard error.
/// @param is_converged true if the study met its criterion
int study_exit_code(const CommonArguments& common, bool is_converged);

/// The input of a study.
struct StudySetup {
  problem::Problem problem;
  OutputDirectory directory;  ///< prepared for the results
};

/// Loads the case of a study and prepares the directory for its results.
/// @throws InputError unless there is exactly one case
StudySetup prepare_study(const CommonArguments& common);

}  // namespace fpkcheck::cli
