#pragma once

#include <span>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/weight.hpp"
#include "backward/generator/impact_basis.hpp"

namespace fpkcheck::backward {

/// Cells of the splines on which the backward equation is solved.
struct Grid {
  int y_cells, speed_cells;
  double finest, even;  ///< of numerics::graded_breaks, in units of the ends
  double edge;          ///< G at the edges of the box, in units of the weight's h0

  bool operator==(const Grid&) const = default;
};

/// What stands at the ends of the box in y, or beyond them: the motion may leave it at an open end,
/// and V is continued by constants to a wall there.
struct Ends {
  bool left_wall = true, right_wall = false;
  bool left_open = false, right_open = true;
};

/// From wall to wall, or as far as G at y' = -c y/2 is below the edge's.
numerics::SplineBasis displacement_basis(const Grid& grid, const Weight& weight,
                                         const problem::System& system);
Ends ends_of(const numerics::SplineBasis& displacement, const problem::System& system);
ImpactBasis velocity_basis(const Grid& grid, const Weight& weight, double restitution);

/// What limits the width of bounds on a grid.
enum class WidthLimit {
  origin,  ///< a power up to 2, and w1: the conical point of V at the origin
  tails,   ///< a higher power: the edges of the box, and rounding where V is large
  knots    ///< the knots of a smooth bin
};
WidthLimit width_limit(const Functional& functional);

/// The grids for such functionals, from the coarsest on; those of the origin and of the tails begin
/// alike.
std::span<const Grid> grids_for(WidthLimit limit);
/// A grid takes less than this many times the time of the one before.
inline constexpr double kCostRatio = 2.5;

}  // namespace fpkcheck::backward
