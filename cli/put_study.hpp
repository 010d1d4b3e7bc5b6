#pragma once

#include <chrono>
#include <string>

#include "cli/command_line.hpp"
#include "cli/ending.hpp"
#include "workflows/study/output.hpp"

namespace fpkcheck::cli {

/// Prints the table or the JSON of a study. With --out, also writes STEM.json, STEM.csv and
/// figures/STEM.gp with its figures. Ends with a line that lists the files.
void put_study(const CommonArguments& common, const study::Output& output,
               std::chrono::steady_clock::time_point begin);

/// The exit code of a study; with --quiet, a failure prints a line to standard error.
/// @param reached true if the study met its criterion
int exit_code_of_study(const CommonArguments& common, bool reached);

/// The input of a study.
struct StudyStart {
  problem::Problem problem;
  OutputDirectory directory;  ///< prepared for the results
};

/// Loads the case of a study and prepares the directory for its results.
/// @throws InputError unless there is exactly one case
StudyStart start_of_study(const CommonArguments& common);

}  // namespace fpkcheck::cli
