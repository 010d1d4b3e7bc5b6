#pragma once

#include <vector>

#include "problem/frame.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// Transforms increasing edges in x = frame.x(y) into increasing edges in y, and back.
std::vector<double> to_y_edges(const problem::Frame& frame, const std::vector<double>& x_edges);
std::vector<double> to_x_edges(const problem::Frame& frame, const std::vector<double>& y_edges);
/// Transforms velocity edges, of which only the sign may change (so the map is its own inverse).
std::vector<double> transform_v_edges(const problem::Frame& frame,
                                      const std::vector<double>& edges);

/// Transforms a density over (x, x') into a density over (y, y'), and back.
/// @param y_edges edges of the axes on which the density may have its cells: cell edges equal to
///        to_x_edges(frame, y_edges) become exactly these numbers (y - origin + origin differs from
///        y by rounding, and histograms are compared on equal edges)
Density to_physical_coordinates(const problem::Frame& frame, Density density,
                                const std::vector<double>& y_edges = {});
Density to_wall_coordinates(const problem::Frame& frame, Density density);

/// Transforms densities, marginals and atoms of a solution from its frame to the physical axes.
/// Moments, their errors and metrics stay unchanged: solvers return these in physical coordinates.
/// @param y_edges edges of the axes passed to the solver, as above; used for its marginals too
Solution to_physical_coordinates(const problem::Frame& frame, Solution solution,
                                 const std::vector<double>& y_edges = {});

}  // namespace fpkcheck::transform
