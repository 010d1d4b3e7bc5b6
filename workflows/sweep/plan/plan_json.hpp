#pragma once

#include "methods/registry.hpp"
#include "results/json.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// A plan as journals have it: whatever two sweeps must share for their results to belong together.
results::Json plan_json(const Plan& plan);

/// The plan that plan_json wrote.
/// @throws nlohmann::json::exception, InputError
Plan plan_in(const results::Json& json, const methods::Registry& registry);

/// In what two plans differ, in words; empty where they are the same.
std::string difference_of(const results::Json& before, const results::Json& now);

}  // namespace fpkcheck::sweep
