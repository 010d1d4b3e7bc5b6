#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/json.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::results {

/// An element of "solutions" in summary.json: the keys that every solution has, then the metrics of
/// its solver.
/// @throws std::logic_error when a metric has the name of one of the common keys
Json solution_json(const transform::Solution& solution);

/// Converts the result of solution_json() back to a solution. The solution has no density.
/// @throws nlohmann::json::exception, InputError
transform::Solution solution_from_json(const Json& json);

}  // namespace fpkcheck::results
