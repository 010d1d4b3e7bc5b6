#pragma once

#include <vector>

#include "problem/frame.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// Increasing edges in coordinates y, of increasing ones in x = frame.x(y); and back.
std::vector<double> y_edges_of(const problem::Frame& frame, const std::vector<double>& x_edges);
std::vector<double> x_edges_of(const problem::Frame& frame, const std::vector<double>& y_edges);
/// Likewise velocities, whose sign alone may change.
std::vector<double> v_edges_of(const problem::Frame& frame, const std::vector<double>& edges);

/// A density over (x, x') as one over (y, y'); and back.
/// @param y_edges of axes of which the density may have cells: edges x_edges_of(frame, y_edges) get
///        these very numbers (y - origin + origin differs from y by rounding, and histograms are
///        compared on equal edges)
Density in_physical_coordinates(const problem::Frame& frame, Density density,
                                const std::vector<double>& y_edges = {});
Density in_coordinates_of(const problem::Frame& frame, Density density);

/// The solution of a problem in its frame, with densities, marginals and atoms on the physical axes.
/// Moments, their errors and observations are left as they are: a solver states the physical ones.
/// @param y_edges of the axes that the solver was given, as above: also of its marginals
Solution in_physical_coordinates(const problem::Frame& frame, Solution solution,
                                 const std::vector<double>& y_edges = {});

}  // namespace fpkcheck::transform
