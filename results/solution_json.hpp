#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/json.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::results {

/// An element of "solutions" in summary.json: what all solutions have, and what its solver alone
/// knows beside it.
/// @throws std::logic_error when an observation claims a common field
Json solution_json(const transform::Solution& solution);

/// The solution that solution_json wrote, without its density.
/// @throws nlohmann::json::exception, InputError
transform::Solution solution_in(const Json& json);

}  // namespace fpkcheck::results
