#pragma once

#include "methods/registry.hpp"
#include "results/json.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Returns the JSON of a plan, with all values that must be equal in two sweeps before their
/// results are joined.
results::Json plan_json(const Plan& plan);

/// Reads a plan from the JSON of plan_json().
/// @throws nlohmann::json::exception, InputError
Plan plan_from_json(const results::Json& json, const methods::SolverRegistry& registry);

/// Returns the first difference as text, e.g. "/vary/0/to: 5.0 then, 6.0 now"; empty if the plans
/// are equal.
std::string first_plan_difference(const results::Json& before, const results::Json& now);

/// The keys of a result in the journal are short, since a journal has many lines.
results::Json point_result_json(const PointResult& result);

/// Returns one line of text, in which control characters are escaped and invalid UTF-8 is replaced.
std::string journal_line(const PointResult& result);

/// Reads the result of a point from the JSON of point_result_json().
/// @throws nlohmann::json::exception, InputError
PointResult point_result_from_json(const results::Json& json);

}  // namespace fpkcheck::sweep
