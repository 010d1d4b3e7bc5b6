#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fpkcheck::compare {

/// One sentence that says what limits each closure of a case: the largest part of its budget (both
/// variables together), or the reference, where the closure is nearer to it than the reference is
/// known. Closures with the same limit are named together. Empty without a budget.
/// @param summary_case one element of "cases" in summary.json, with its "budget"
std::string limits(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
