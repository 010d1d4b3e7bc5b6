#pragma once

#include <functional>
#include <vector>

#include "problem/walls.hpp"
#include "transform/density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A joint density of (z, z') = (x1, x2) on the whole plane, which is zero outside |x1| <= x1_max,
/// |x2| <= x2_max.
struct ZhuravlevDensity {
  std::function<double(double x1, double x2)> value;
  double x1_max;
  double x2_max;
};

/// Returns the density p of (y, y') = (|z|, z' sgn z), the Zhuravlev transformation of paper (5):
///
///     p(y, v) = p(z = y, z' = v) + p(z = -y, z' = -v),   y > 0.
///
/// The marginals of p(y, v) are paper (30) and (34). The density of (z, z') need not be symmetric.
SmoothDensity zhuravlev_transform(ZhuravlevDensity density);

/// Transforms increasing cell edges in wall coordinates x into increasing cell edges in physical
/// coordinates y (to_y_edges), and back (to_x_edges).
std::vector<double> to_y_edges(const problem::WallFrame& frame, const std::vector<double>& x_edges);
std::vector<double> to_x_edges(const problem::WallFrame& frame, const std::vector<double>& y_edges);
/// Transforms increasing cell edges of the velocity between wall and physical coordinates, in
/// either direction, since at most the sign changes.
std::vector<double> transform_v_edges(const problem::WallFrame& frame,
                                      const std::vector<double>& edges);

/// Transforms a density of (x, x') in wall coordinates into a density of (y, y') in physical
/// coordinates (to_physical_coordinates), and back (to_wall_coordinates).
/// @param y_edges cell edges in y. Cell edges of the density that equal to_x_edges(frame, y_edges)
/// become exactly the numbers `y_edges`, without the rounding errors of the transformation, since
/// histograms are compared only on equal edges.
Density to_physical_coordinates(const problem::WallFrame& frame, Density density,
                                const std::vector<double>& y_edges = {});
Density to_wall_coordinates(const problem::WallFrame& frame, Density density);

/// Transforms densities, marginals and atoms of a solution from wall coordinates to physical
/// coordinates. Moments, their errors and metrics are unchanged, since solvers return these
/// quantities in physical coordinates.
/// @param y_edges cell edges in y that were passed to the solver; edges of densities and marginals
/// become exactly these numbers
Solution to_physical_coordinates(const problem::WallFrame& frame, Solution solution,
                                 const std::vector<double>& y_edges = {});

}  // namespace fpkcheck::transform
