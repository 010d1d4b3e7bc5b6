#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fpkcheck::compare {

/// The solution that the others are measured against in one case: the full jump equation, which has
/// no noise; else the simulation; "" when neither is ok.
std::string reference_of(const nlohmann::ordered_json& summary_case);

/// Ids of the closures that are ok, by their distance from the reference (the sum over both
/// variables), the closest first; in their own order without a reference.
std::vector<std::string> closures_by_distance(const nlohmann::ordered_json& summary_case);

/// Ids of the solutions that a plot shows before anybody has chosen: the reference, the simulation
/// and the closest closure of each formulation; all that there are when that leaves fewer than two.
std::vector<std::string> first_shown(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
