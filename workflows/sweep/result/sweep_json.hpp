#pragma once

#include "methods/registry.hpp"
#include "results/json_conversions.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Returns the JSON of a plan. The results of two sweeps may be joined only if the JSON texts of
/// their plans are equal.
results::Json sweep_plan_json(const SweepPlan& plan);

/// Reads a sweep plan from the JSON of sweep_plan_json().
/// @throws nlohmann::json::exception, InputError
SweepPlan sweep_plan_from_json(const results::Json& json, const methods::SolverRegistry& registry);

/// Returns the first difference between two sweep plans as text, e.g. "/vary/0/to: 5.0 then, 6.0
/// now". The text is empty for equal plans.
std::string first_sweep_plan_difference(const results::Json& before, const results::Json& now);

/// Returns the result of a sweep point as JSON with short keys, since a journal has many lines.
results::Json point_result_json(const SweepPointResult& result);

/// Returns the journal line of a sweep point's result, with control characters escaped and invalid
/// UTF-8 replaced.
std::string sweep_journal_line(const SweepPointResult& result);

/// Reads the result of a point from the JSON of point_result_json().
/// @throws nlohmann::json::exception, InputError
SweepPointResult point_result_from_json(const results::Json& json);

}  // namespace fpkcheck::sweep
