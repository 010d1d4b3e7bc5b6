#pragma once

#include "results/json.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

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
