#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/json.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::results {

/// Returns an element of "solutions" in summary.json: the common keys of all solutions, then the
/// metrics of the solver.
/// @throws std::logic_error if a metric has the name of a common key
Json solution_json(const transform::Solution& solution);

/// Converts the result of solution_json() back to a solution without a density.
/// @throws nlohmann::json::exception, InputError
transform::Solution solution_from_json(const Json& json);

}  // namespace fpkcheck::results
