#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/command_line.hpp"
#include "compare/run_directory.hpp"

namespace fpkcheck::cli {

/// What a study leaves.
struct StudyOutput {
  std::string stem;  ///< of its files, e.g. "study-order"
  nlohmann::ordered_json report;
  std::string table;
  std::string csv;
  std::string figure = {};  ///< a gnuplot script; empty for none
};

/// Prints a study's table or its JSON, writes STEM.json, STEM.csv and figures/STEM.png, .svg, .gp
/// when a directory was given, and closes with what was written where.
void put_study(const CommonArguments& common, const StudyOutput& study,
               std::chrono::steady_clock::time_point begin);

/// What a study begins with.
struct StudyStart {
  problem::Problem problem;
  compare::MadeDirectories made;  ///< for its results
};

/// The one case that a study takes; the directory for its results is prepared.
/// @throws InputError when there is not exactly one
StudyStart start_of_study(const CommonArguments& common);

}  // namespace fpkcheck::cli
