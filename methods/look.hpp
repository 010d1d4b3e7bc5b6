#pragma once

#include <array>
#include <string>

#include "transform/identity.hpp"

/// The looks of the built-in methods. Hues are those of Okabe and Ito, which stay apart for
/// colour-blind readers.
namespace fpkcheck::methods {

/// Shades of one hue for the orders 2, 4, .. 12, darker with the order.
using Ramp = std::array<const char*, 6>;
inline constexpr Ramp kOrange{"#E69F00", "#D55E00", "#A63603", "#7F2704", "#5C1A02", "#3D1000"};
inline constexpr Ramp kPurple{"#E3A8C8", "#CC79A7", "#B3558C", "#8E3A73", "#6A2058", "#45103A"};
inline constexpr Ramp kOlive{"#C9C46A", "#A8A23A", "#87811F", "#66610F", "#4A4606", "#2E2B00"};

/// A closure: one hue a formulation; the higher the order, the darker the shade and the more ink in
/// its dashes. Drawn above the equations.
/// @param symbol a marker of plotly.js
transform::Look closure_look(const Ramp& ramp, const transform::Identity& identity,
                             const std::string& symbol);

/// A density equation: a solid line, that of the full jump integral broad and beneath all others.
transform::Look equation_look(const transform::Identity& identity);

/// A simulation: points above the lines.
transform::Look simulation_look(const transform::Identity& identity);

/// What a file gave: dashed and on top.
/// @param place among several files
transform::Look given_look(std::size_t place);

}  // namespace fpkcheck::methods
