#pragma once

#include <chrono>
#include <string>

#include "cli/command_line.hpp"
#include "cli/ending.hpp"
#include "workflows/study/output.hpp"

namespace fpkcheck::cli {

/// Prints a study's table or its JSON, writes STEM.json, STEM.csv and figures/STEM.gp with its pictures
/// when a directory was given, and closes with what was written where.
void put_study(const CommonArguments& common, const study::StudyOutput& output,
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
