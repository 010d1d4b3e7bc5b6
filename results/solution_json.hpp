#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/json.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::results {

/// An element of "solutions" in summary.json: the keys of all solutions, and the metrics of the
/// solver.
/// @throws std::logic_error when a metric has the key of a common field
Json solution_json(const transform::Solution& solution);

/// Reads an element that solution_json wrote; the solution has no density.
/// @throws nlohmann::json::exception, InputError
transform::Solution solution_in(const Json& json);

}  // namespace fpkcheck::results
