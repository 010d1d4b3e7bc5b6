#pragma once

#include "results/json.hpp"
#include "sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// A point as a line of the journal: short keys, since there are many.
results::Json point_json(const PointResult& result);

/// @throws nlohmann::json::exception, InputError
PointResult point_in(const results::Json& json);

}  // namespace fpkcheck::sweep
