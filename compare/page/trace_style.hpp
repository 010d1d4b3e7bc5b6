#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/figure/curve_style.hpp"

/// The look of a solution in plotly.js: that of the pictures (figure/curve_style.hpp).
namespace fpkcheck::compare {

/// The "line" of a trace.
nlohmann::ordered_json line_of(const CurveStyle& style);

/// A name for legends: the id, with the status of a solution that is not ok.
std::string legend_name(const nlohmann::ordered_json& solution);

}  // namespace fpkcheck::compare
