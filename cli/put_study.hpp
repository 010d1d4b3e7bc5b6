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

/// kDone where it reached what it must, else kNotReached; of a quiet one a line says so.
int exit_code_of_study(const CommonArguments& common, bool reached);

/// What a study begins with.
struct StudyStart {
  problem::Problem problem;
  OutputDirectory directory;  ///< for its results
};

/// The one case that a study takes; the directory for its results is prepared.
/// @throws InputError when there is not exactly one
StudyStart start_of_study(const CommonArguments& common);

}  // namespace fpkcheck::cli
