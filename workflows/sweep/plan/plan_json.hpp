#pragma once

#include "methods/registry.hpp"
#include "results/json.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// The JSON of a plan for journals. The JSON contains all values that must be equal in two sweeps
/// whose results are joined.
results::Json plan_json(const Plan& plan);

/// Reads a plan from the JSON that plan_json makes.
/// @throws nlohmann::json::exception, InputError
Plan plan_from_json(const results::Json& json, const methods::Registry& registry);

/// The text that describes the first difference between two plans; empty if the plans are equal.
std::string plan_difference(const results::Json& before, const results::Json& now);

}  // namespace fpkcheck::sweep
