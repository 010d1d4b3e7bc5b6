#pragma once

#include <chrono>
#include <string>

#include "cli/command_line.hpp"
#include "cli/shutdown.hpp"
#include "workflows/study/output.hpp"

namespace fpkcheck::cli {

/// Prints the table of a study or its JSON. With --out writes STEM.json, STEM.csv and
/// figures/STEM.gp with its pictures. The last line of the output names the written files.
void write_study(const CommonArguments& common, const study::StudyOutput& output,
                 std::chrono::steady_clock::time_point start_time);

/// Exit code of a study. With --quiet a failure prints a line to standard error.
/// @param is_converged whether the study met its criterion
int study_exit_code(const CommonArguments& common, bool is_converged);

/// Problem and output directory of a study.
struct StudySetup {
  problem::Problem problem;
  OutputDirectory directory;  ///< prepared output directory
};

/// Loads the case of a study and prepares the directory for its results.
/// @throws InputError unless there is exactly one case
StudySetup prepare_study(const CommonArguments& common);

}  // namespace fpkcheck::cli
