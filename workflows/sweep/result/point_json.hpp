#pragma once

#include "results/json.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// JSON of a point for a line of the journal. The keys are short, since there are many lines.
results::Json point_json(const PointResult& result);

/// point_json on one line; control characters in texts are escaped, invalid UTF-8 is replaced.
std::string journal_text(const PointResult& result);

/// The point from the JSON of point_json.
/// @throws nlohmann::json::exception, InputError
PointResult point_from_json(const results::Json& json);

}  // namespace fpkcheck::sweep
