#pragma once

#include <span>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/weight.hpp"
#include "backward/generator/impact_basis.hpp"

namespace fpkcheck::backward {

/// Cells of the splines in the fit of the backward equation.
struct SplineGrid {
  int y_cells, speed_cells;
  double finest, even;  ///< arguments of numerics::graded_breaks, relative to the extents
  double edge;          ///< G at the edges of the box, in units of h0 of the weight

  bool operator==(const SplineGrid&) const = default;
};

/// Kinds of the two ends of the box in y. The motion can leave the box at an open end, beyond which
/// V is constant in y up to the wall, if there is one.
struct BoxEnds {
  bool left_wall = true, right_wall = false;
  bool left_open = false, right_open = true;
};

/// Splines from wall to wall, or to the points where G at y' = -c y/2 has its value at the edge.
numerics::SplineBasis displacement_basis(const SplineGrid& grid, const Weight& weight,
                                         const problem::System& system);
BoxEnds box_ends(const numerics::SplineBasis& displacement, const problem::System& system);
ImpactBasis velocity_basis(const SplineGrid& grid, const Weight& weight, double restitution);

/// The feature of V that limits the width of the bounds on a grid.
enum class WidthLimit {
  origin,  ///< powers up to 2 and w1: the conical point of V at the origin
  tails,   ///< higher powers: the edges of the box, and rounding where V is large
  knots    ///< smooth bins: their knots
};
WidthLimit width_limit(const Functional& functional);

/// The sequence of grids for a limit, from the coarsest. The first grids of `origin` and `tails`
/// are equal.
std::span<const SplineGrid> grid_sequence(WidthLimit limit);
/// Upper limit of the ratio of the times of consecutive grids.
inline constexpr double kGridCostRatio = 2.5;

}  // namespace fpkcheck::backward
