#pragma once

#include "dual/bounds/weight.hpp"
#include "dual/spline/impact_basis.hpp"

namespace fpkcheck::dual {

/// Cells of the splines on which the backward equation is solved.
struct Grid {
  int y_cells, speed_cells;
  double finest, even;  ///< of graded_breaks, in units of the ends
  double edge;          ///< G at the edges of the box, in units of the weight's h0
};

/// What stands at the ends of the box in y, or beyond them: the motion may leave it at an open end,
/// and V is continued by constants to a wall there.
struct Ends {
  bool left_wall = true, right_wall = false;
  bool left_open = false, right_open = true;
};

/// From wall to wall, or as far as G at y' = -c y/2 is below the edge's.
SplineBasis displacement_basis(const Grid& grid, const Weight& weight,
                               const problem::System& system);
Ends ends_of(const SplineBasis& displacement, const problem::System& system);
ImpactBasis velocity_basis(const Grid& grid, const Weight& weight, double restitution);

/// What limits the accuracy of V.
enum class Smoothness {
  smooth,    ///< a polynomial integrand: the conical point at the origin
  piecewise  ///< the knots of a smooth bin
};

/// Grids of the ladder, from the coarsest on.
inline constexpr int kLevels = 5;
Grid grid_of_level(int level, Smoothness integrand);
/// A grid takes less than this many times the time of the one before.
inline constexpr double kCostRatio = 2.5;

}  // namespace fpkcheck::dual
