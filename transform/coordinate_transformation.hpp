#pragma once

#include <functional>
#include <vector>

#include "problem/walls.hpp"
#include "transform/joint_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A joint density of the variables (z, z') = (x1, x2) of paper (5) on the whole plane, which is
/// zero outside |x1| <= x1_max, |x2| <= x2_max.
struct ZhuravlevDensity {
  std::function<double(double x1, double x2)> value;
  double x1_max;
  double x2_max;
};

/// Returns the density p of (y, y') = (|z|, z' sgn z), the Zhuravlev transformation of paper (5):
///
///     p(y, v) = p(z = y, z' = v) + p(z = -y, z' = -v),   y > 0.
///
/// The marginals of p(y, v) are paper (30), (34). The density of (z, z') need not be symmetric.
SmoothDensity zhuravlev_transform(ZhuravlevDensity density);

/// The function y_edges_from_wall_coordinates() transforms increasing cell edges from wall
/// coordinates x to physical coordinates y. The function wall_coordinate_edges() transforms cell
/// edges from y to x.
std::vector<double> y_edges_from_wall_coordinates(const problem::WallFrame& frame,
                                                  const std::vector<double>& x_edges);
std::vector<double> wall_coordinate_edges(const problem::WallFrame& frame,
                                          const std::vector<double>& y_edges);
/// Transforms increasing cell edges of the velocity from wall to physical coordinates or back. The
/// transformation of velocity edges is its own inverse, since at most the sign of the velocity
/// changes.
std::vector<double> transform_v_edges(const problem::WallFrame& frame,
                                      const std::vector<double>& edges);

/// The function to_physical_coordinates() transforms a density of (x, x') in wall coordinates to a
/// density of (y, y') in physical coordinates. The function to_wall_coordinates() transforms a
/// density from physical to wall coordinates.
/// @param y_edges cell edges in y. Edges of the density equal to wall_coordinate_edges(frame,
/// y_edges) become exactly `y_edges`, without rounding errors, since only histograms with equal
/// edges can be compared.
Density to_physical_coordinates(const problem::WallFrame& frame, Density density,
                                const std::vector<double>& y_edges = {});
Density to_wall_coordinates(const problem::WallFrame& frame, Density density);

/// Transforms densities, marginals and atoms of a solution from wall coordinates to physical
/// coordinates. Moments, errors of moments and metrics are unchanged, since solvers return moments
/// and metrics in physical coordinates.
/// @param y_edges cell edges in y that were passed to the solver. Edges of transformed densities
/// and marginals become exactly `y_edges`.
Solution to_physical_coordinates(const problem::WallFrame& frame, Solution solution,
                                 const std::vector<double>& y_edges = {});

}  // namespace fpkcheck::transform
