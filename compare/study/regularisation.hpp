#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/text/format.hpp"
#include "fd_fpk/regularisation_study.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::compare {

/// The contents of study-regularisation.json: program, name, system and impulse of the case as in
/// summary.json, the two lengths, and a row per scheme and step. Null where a row has no number;
/// `growth_rate` is null where nothing grows.
/// @param command the command line of the run
nlohmann::ordered_json regularisation_report(const std::string& command,
                                             const problem::Problem& problem,
                                             const fd_fpk::RegularisationStudy& study);

/// The rows as study-regularisation.csv, under a header; empty where a row has no number.
std::string regularisation_csv(const nlohmann::ordered_json& report);

/// The rows as a table, remarks on what is missing, and what the numbers say, in sentences.
/// @param format the least important columns go where the rows do not fit
std::string regularisation_table(const nlohmann::ordered_json& report,
                                 const TextFormat& format = {});

}  // namespace fpkcheck::compare
