#pragma once

#include <array>
#include <string>

#include "transform/identity.hpp"

/// The plot styles of all methods, in every figure and on the page. Families differ by hue (palette
/// of Okabe and Ito, distinguishable by colour-blind readers) and, for grey print, by marker shape.
/// Members of a family differ by shade and dash pattern. The markers are the shapes that plotly.js
/// and gnuplot provide both filled and open. A test (tests/methods/plot_style_test.cpp) requires
/// that every pair of styles is distinguishable in grey and in simulated deuteranopia.
namespace fpkcheck::methods {

/// Shades of one hue for the orders 2, 4, .. 12, darker with the order.
using ColourRamp = std::array<const char*, 6>;
inline constexpr ColourRamp kOrange{"#E69F00", "#D55E00", "#A63603",
                                    "#7F2704", "#5C1A02", "#3D1000"};
inline constexpr ColourRamp kPurple{"#E3A8C8", "#CC79A7", "#B3558C",
                                    "#8E3A73", "#6A2058", "#45103A"};
inline constexpr ColourRamp kOlive{"#C9C46A", "#A8A23A", "#87811F",
                                   "#66610F", "#4A4606", "#2E2B00"};

/// The style of a closure: one hue and one marker for each formulation. The higher the order, the
/// darker the shade and the larger the drawn share of the dashes. The layer is above the equations.
/// @param symbol a marker of plotly.js
transform::PlotStyle closure_style(const ColourRamp& ramp, const transform::Identity& identity,
                                   const std::string& symbol);

/// The style of a density equation: a line. The full jump integral has a broad solid line on the
/// lowest layer.
transform::PlotStyle equation_style(const transform::Identity& identity);

/// The style of a finite-volume scheme, in studies that compare schemes of several orders.
/// @param rank of the scheme among the orders, from the lowest
transform::PlotStyle scheme_style(std::size_t rank);

/// The style of a simulation: points on a layer above the lines.
transform::PlotStyle simulation_style(const transform::Identity& identity);

/// The style of an external density: dashed, on the top layer.
/// @param rank of the density among all external densities
transform::PlotStyle external_style(std::size_t rank);
/// The style of a member of a family of external densities, by its order.
/// @param rank of the family among all external densities
transform::PlotStyle external_family_style(std::size_t rank, int order);

}  // namespace fpkcheck::methods
