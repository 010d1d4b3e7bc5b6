#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fpkcheck::compare {

/// Plain sentences that say which approximation costs what in one case, from the distances of the
/// solutions that are there and ok:
///
///   - the discretisation error of a solution that estimated its own, or the largest of several;
///     not where there is an error budget, which has them;
///   - white noise instead of impulses, the cut series instead of the jump integral, the
///   first-order
///     impact instead of the exact one: each against the solution that differs in that alone;
///   - the closest exponential-polynomial closure of each formulation;
///   - the full equation against the simulation, beside the simulation's own sampling error;
///   - solutions from files against both, beside what their standard errors explain, and what was
///     made of the files.
///
/// @param summary_case one element of "cases" in summary.json
std::vector<std::string> findings(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
