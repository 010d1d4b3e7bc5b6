#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fpkcheck::compare {

/// How a solution is drawn. Hues are those of Okabe and Ito, which stay apart for colour-blind
/// readers; the closures of one formulation share a hue.
struct CurveStyle {
  std::string colour;  ///< "#RRGGBB"
  std::string dash;    ///< a dash type of gnuplot
  double width;
  bool as_points;  ///< hollow points with 95 % intervals instead of a line
  int layer;       ///< lower layers are drawn first
};

/// Finite differences are solid, the trusted one broad and beneath all others; closures are dashed
/// by their order, darker with it, and above them; the simulation is points
/// above these, and what a file gave is dotted and on top.
/// @param solution one element of "solutions" in summary.json
CurveStyle curve_style(const nlohmann::ordered_json& solution);

}  // namespace fpkcheck::compare
