#pragma once

#include "methods/registry.hpp"
#include "results/json.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// The JSON of a plan for journals. The JSON contains all values of a plan that must be equal in
/// two sweeps before their results can be joined.
results::Json plan_json(const Plan& plan);

/// Reads a plan from the JSON that plan_json makes.
/// @throws nlohmann::json::exception, InputError
Plan plan_from_json(const results::Json& json, const methods::Registry& registry);

/// The text of the first difference between two plans, with the JSON pointer of the value that
/// differs: "/vary/0/to: 5.0 then, 6.0 now"; empty if the plans are equal.
std::string plan_difference(const results::Json& before, const results::Json& now);

/// The JSON of a point's result for a line of the journal. The keys are short, since a journal has
/// many lines.
results::Json point_json(const PointResult& result);

/// The JSON of point_json as one line of text; control characters in texts are escaped, and invalid
/// UTF-8 is replaced.
std::string journal_line(const PointResult& result);

/// Reads the result of a point from the JSON that point_json makes.
/// @throws nlohmann::json::exception, InputError
PointResult point_from_json(const results::Json& json);

}  // namespace fpkcheck::sweep
