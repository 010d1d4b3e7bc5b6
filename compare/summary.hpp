#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "compare/case_report.hpp"

namespace fpkcheck::compare {

/// Version of the shape of summary.json.
inline constexpr int kSummarySchema = 1;

/// The program's version, from the build.
std::string program_version();

/// The name and version of the program, and its command line: what every file of results opens
/// with.
nlohmann::ordered_json program_json(const std::string& command);

/// A case's name, "system" and "impulse", as in summary.json.
nlohmann::ordered_json case_json(const problem::Problem& problem);

/// The problem that case_json wrote, from a case of summary.json.
/// @throws InputError naming the field that is missing, unknown, of the wrong type or out of range
problem::Problem problem_from_json(const nlohmann::ordered_json& summary_case);

/// JSON has no infinities: numbers that are not finite become null.
nlohmann::ordered_json with_null_for_non_finite(nlohmann::ordered_json value);

/// The contents of summary.json: everything a run found but the curves.
/// A number that is not finite becomes null, and so do the moments, the mass and the energy
/// residual of a solution without a density.
/// @param command the command line of the run
/// @throws std::logic_error when an entry's details are not an object or claim a common field
nlohmann::ordered_json summary(const std::string& command, std::span<const CaseReport> cases);

}  // namespace fpkcheck::compare
