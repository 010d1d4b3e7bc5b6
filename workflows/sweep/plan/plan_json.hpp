#pragma once

#include "methods/registry.hpp"
#include "results/json.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// JSON of a plan for journals. It contains all that two sweeps must share for their results to be
/// joined.
results::Json plan_json(const Plan& plan);

/// The plan from the JSON of plan_json.
/// @throws nlohmann::json::exception, InputError
Plan plan_from_json(const results::Json& json, const methods::Registry& registry);

/// Text of the first difference between two plans; empty where they are equal.
std::string plan_difference(const results::Json& before, const results::Json& now);

}  // namespace fpkcheck::sweep
