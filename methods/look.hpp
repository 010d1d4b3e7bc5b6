#pragma once

#include <array>
#include <string>

#include "transform/identity.hpp"

/// The one palette: how everything that is drawn of a method looks, in every picture and on the
/// page. Families differ by hue (of Okabe and Ito, which stay apart for colour-blind readers) and,
/// for grey print, by the shape of their marks; members of a family by shade and dash. Marks are
/// those shapes that plotly.js and gnuplot have both filled and open. The test of looks holds all
/// pairs apart in grey and in simulated deuteranopia.
namespace fpkcheck::methods {

/// Shades of one hue for the orders 2, 4, .. 12, darker with the order.
using Ramp = std::array<const char*, 6>;
inline constexpr Ramp kOrange{"#E69F00", "#D55E00", "#A63603", "#7F2704", "#5C1A02", "#3D1000"};
inline constexpr Ramp kPurple{"#E3A8C8", "#CC79A7", "#B3558C", "#8E3A73", "#6A2058", "#45103A"};
inline constexpr Ramp kOlive{"#C9C46A", "#A8A23A", "#87811F", "#66610F", "#4A4606", "#2E2B00"};

/// A closure: one hue and mark a formulation; the higher the order, the darker the shade and the
/// more ink in its dashes. Drawn above the equations.
/// @param symbol a marker of plotly.js
transform::PlotStyle closure_look(const Ramp& ramp, const transform::Identity& identity,
                                  const std::string& symbol);

/// A density equation: a line, that of the full jump integral broad, solid and beneath all others.
transform::PlotStyle equation_look(const transform::Identity& identity);

/// Finite differences by the order of their scheme, where that is what differs.
/// @param place among the orders, from the lowest
transform::PlotStyle scheme_look(std::size_t place);

/// A simulation: points above the lines.
transform::PlotStyle simulation_look(const transform::Identity& identity);

/// What a file gave: dashed and on top.
/// @param place among several files
transform::PlotStyle given_look(std::size_t place);
/// A member of a family of these, by its order.
/// @param place of the family
transform::PlotStyle given_family_look(std::size_t place, int order);

}  // namespace fpkcheck::methods
