#pragma once

#include <span>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/generator/impact_basis.hpp"

namespace fpkcheck::backward {

/// Numbers of cells, widths of cells and extent of the splines by which a certificate V is fitted.
struct SplineGrid {
  int y_cell_count;      ///< number of cells of y, if the only wall is at y = 0
  int speed_cell_count;  ///< number of cells of the impact speed, the same before and after impacts
  /// Arguments `finest` and `uniform_from` of numerics::graded_break_points for one axis, as
  /// fractions of the extent of this axis
  double finest_fraction, uniform_from_fraction;
  /// Energy G (ResidualWeightFunctionOfEnergy) on the edges of the box of the splines, in units of
  /// the energy scale h0
  double edge_energy;

  bool operator==(const SplineGrid&) const = default;
};

/// Types of the two ends of the box in y. At an open end of the splines of y, which is no wall, the
/// motion can leave the box of the splines. Beyond an open end of the splines of y, the certificate
/// V is constant in y, up to the wall on that side, if any.
struct DisplacementBoundaryTypes {
  bool has_left_wall = true, has_right_wall = false;
  bool is_left_end_open = false, is_right_end_open = true;
};

/// Makes the splines of the displacement y, which extend from wall to wall. On a side without a
/// wall, or with a distant wall, the splines of y end where the least energy G over all velocities
/// (at y' = -c y/2) equals SplineGrid::edge_energy times the energy scale h0.
numerics::SplineBasis make_displacement_spline_basis(const SplineGrid& grid,
                                                     const ResidualWeightFunctionOfEnergy& weight,
                                                     const problem::System& system);

/// Returns the types (wall or open end) of the two ends of the splines of y.
DisplacementBoundaryTypes find_displacement_end_types(
    const numerics::SplineBasis& displacement_basis, const problem::System& system);

/// Makes the spline basis of v. Without impact losses (restitution coefficient r = 1) the splines
/// of the impact speed end at v^2/2 = edge_energy h0. With impact losses the range of the splines
/// of the impact speed is larger than without losses.
ImpactSplineBasis make_velocity_spline_basis(const SplineGrid& grid,
                                             const ResidualWeightFunctionOfEnergy& weight,
                                             double restitution);

/// Feature of the certificate V that limits how narrow the guaranteed bounds on a grid can be.
enum class BoundWidthLimitingFeature {
  conical_point,  ///< for powers up to 2 and w1: the conical point of V at the origin
  tails,          ///< for higher powers: the edges of the box, and rounding where V is large
  bin_knots       ///< for smooth bins: the knots of the bin
};
BoundWidthLimitingFeature bound_width_limiting_feature(const StationaryFunctional& functional);

/// Returns the spline grids, from coarse to fine, for functionals whose bounds the feature limits.
std::span<const SplineGrid> spline_grid_sequence(BoundWidthLimitingFeature feature);

/// Upper limit of the ratio of the computing times of consecutive spline grids of a sequence.
inline constexpr double kMaxGridTimeRatio = 2.5;

}  // namespace fpkcheck::backward
