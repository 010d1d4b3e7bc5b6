#pragma once

#include <array>

#include "transform/solution_identity.hpp"

/// The plot styles of all methods, for figures and for the page of the report. Families of methods
/// differ by hue and marker shape. The hues of the plot styles are the palette of Okabe and Ito,
/// which colour-blind readers can distinguish. Members of a family of methods differ by shade and
/// dash pattern. All marker shapes exist, filled and open, in plotly.js and in gnuplot. The test
/// tests/methods/plot_style_test.cpp requires that all pairs of plot styles are distinguishable in
/// grey and in simulated deuteranopia.
namespace fpkcheck::methods {

/// Six shades of one hue, from light to dark, for the closure orders 2, 4, .. 12.
using ColourRamp = std::array<const char*, 6>;
inline constexpr ColourRamp kOrange{"#E69F00", "#D55E00", "#A63603",
                                    "#7F2704", "#5C1A02", "#3D1000"};
inline constexpr ColourRamp kPurple{"#E3A8C8", "#CC79A7", "#B3558C",
                                    "#8E3A73", "#6A2058", "#45103A"};
inline constexpr ColourRamp kOlive{"#C9C46A", "#A8A23A", "#87811F",
                                   "#66610F", "#4A4606", "#2E2B00"};

/// Returns the plot style of a closure. Each formulation of a closure has one hue and one marker.
/// The shade becomes darker, and the dashes become longer, as the closure order increases. Curves
/// of closures are drawn above curves of density equations.
transform::PlotStyle closure_style(const transform::SolutionIdentity& identity);

/// Returns the plot style, a line, of a solution of a discretised density equation. The density
/// equation with the full jump integral has a broad solid line, drawn below all other curves.
transform::PlotStyle density_equation_style(const transform::SolutionIdentity& identity);

/// @param rank index of the finite-volume scheme by increasing order of accuracy, from 0
transform::PlotStyle finite_volume_scheme_style(std::size_t rank);

/// Returns the plot style of a method for comparison with the literature, such as statistical
/// linearisation.
/// @param rank index of the method among all methods for comparison with the literature, from 0
transform::PlotStyle literature_method_style(std::size_t rank);

/// Returns the plot style of a simulation: points, drawn above all lines.
transform::PlotStyle simulation_style(const transform::SolutionIdentity& identity);

/// Returns the plot style of an external density: a dashed line, drawn above all other curves.
/// @param rank index of the external density among all external densities, from 0
transform::PlotStyle external_density_style(std::size_t rank);
/// @param rank index of the first member of the family among all external densities, from 0
/// @param order order of the closure
transform::PlotStyle external_family_style(std::size_t rank, int order);

}  // namespace fpkcheck::methods
