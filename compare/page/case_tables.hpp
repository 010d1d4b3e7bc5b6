#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// The tables of one case, from its element of "cases" in summary.json.
namespace fpkcheck::compare {

/// A row per solution: what it solves, status, moments, distances, energy, seconds.
std::string results_table(const nlohmann::ordered_json& summary_case);

/// Why solutions are not ok, as a list; empty when all are.
std::string reasons_html(const nlohmann::ordered_json& summary_case);

/// What closures, finite differences and the simulation have to say of themselves: admissibility,
/// well-posedness, mass, energy, residuals, errors estimated and chance.
std::string diagnostics_tables(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
