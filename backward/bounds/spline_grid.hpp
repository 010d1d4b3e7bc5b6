#pragma once

#include <span>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/generator/impact_basis.hpp"

namespace fpkcheck::backward {

/// Numbers and grading of the spline cells in the fit of the backward equation.
struct SplineGrid {
  int y_cells, speed_cells;
  double finest, even;  ///< arguments of numerics::graded_breaks, relative to the extents
  double edge;          ///< energy G (ResidualWeight) at the edges of the box, in units of h0

  bool operator==(const SplineGrid&) const = default;
};

/// Kinds of the two ends of the box in y. The motion can leave the box at an open end. Beyond an
/// open end the certificate V is constant in y, up to a wall if present.
struct BoxEndTypes {
  bool left_wall = true, right_wall = false;
  bool left_open = false, right_open = true;
};

/// Returns the splines of y from wall to wall. On a side without a wall the splines end where the
/// energy G of ResidualWeight, at y' = -c y/2, equals SplineGrid::edge times the energy scale h0.
numerics::SplineBasis displacement_spline_basis(const SplineGrid& grid,
                                                const ResidualWeight& weight,
                                                const problem::System& system);
BoxEndTypes box_end_types(const numerics::SplineBasis& displacement, const problem::System& system);
ImpactBasis velocity_spline_basis(const SplineGrid& grid, const ResidualWeight& weight,
                                  double restitution);

/// Feature of the certificate V that limits how narrow the bounds on a grid can be.
enum class WidthLimitingFeature {
  origin,  ///< for powers up to 2 and w1: the conical point of V at the origin
  tails,   ///< for higher powers: the edges of the box, and rounding where V is large
  knots    ///< for smooth bins: the knots of the bin
};
WidthLimitingFeature width_limiting_feature(const Functional& functional);

/// Returns the sequence of grids, from coarse to fine, for functionals whose bounds are limited by
/// the feature `limit`.
std::span<const SplineGrid> spline_grid_sequence(WidthLimitingFeature limit);
/// Upper limit of the ratio of the computing times of consecutive grids of a sequence
inline constexpr double kGridCostRatio = 2.5;

}  // namespace fpkcheck::backward
