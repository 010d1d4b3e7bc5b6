#pragma once

#include "results/json.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// A point as a line of the journal: short keys, since there are many.
results::Json point_json(const PointResult& result);

/// point_json on one line, whatever its texts hold.
std::string journal_text(const PointResult& result);

/// @throws nlohmann::json::exception, InputError
PointResult point_in(const results::Json& json);

}  // namespace fpkcheck::sweep
