#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fd_fpk/axis/axis_operators.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::fd_fpk {

/// Interpolation of the cumulative distribution C(x), the integral of a density p from the first
/// face of an axis to x, between the cell faces. The cell averages of the density p determine the
/// cumulative distribution exactly at the cell faces. A scheme that computes cell averages from
/// differences of functions of the cumulative distribution conserves mass.
class SpeedDistributionInterpolation {
 public:
  static constexpr int kMaxInterpolationPoints = 10;

  /// @param face_count number of faces in each stencil, at most kMaxInterpolationPoints; the
  /// interpolation is exact for a polynomial density of degree face_count - 2
  /// @param left_end condition at the left end of the axis. With the end condition `boundary`,
  /// interpolation stencils remain on the axis; with `vacuum`, the cumulative distribution is 0
  /// left of the axis. The cumulative distribution C is constant right of the axis.
  SpeedDistributionInterpolation(const GridAxis& axis, int face_count, AxisEndCondition left_end);

  /// Adds `factor` times the interpolation weights of the cumulative distribution C at x to
  /// `face_weights`, the weights of the values of the cumulative distribution at the cell faces.
  void add_distribution_interpolation_weights(double x, double factor,
                                              Eigen::Ref<Eigen::VectorXd> face_weights) const;

  /// Converts weights of the values of a cumulative distribution C at cell faces to weights of cell
  /// averages. The cumulative distribution at cell face f is the sum of cell width times cell
  /// average over all cells left of face f.
  Eigen::VectorXd cell_average_weights_from_face_weights(
      const Eigen::Ref<const Eigen::VectorXd>& face_weights) const;

 private:
  // Positions x_a of the cell faces around a cell, and the inverse denominators 1 / prod_{b != a}
  // (x_a - x_b) of Lagrange interpolation.
  struct Stencil {
    int first;
    std::array<double, kMaxInterpolationPoints> faces;
    std::array<double, kMaxInterpolationPoints> inverse_denominators;
  };

  const GridAxis& axis_;
  int points_;
  std::vector<Stencil> stencils_;  // stencils of all cells of the axis
};

/// Returns the matrix, shape (cells, cells), that maps the probability flux into a wall to the
/// probability flux off the wall. The two probability fluxes are given as averages over the cells
/// of the speed axis. Motion reaches the wall x1 = 0 at the speed u with the probability flux f(u)
/// = u p(0, -u). The probability flux off the wall at the rebound speed w is
///
///     map     f(w/r)/r,                          p(0+, w) = p(0-, w/r)/r^2: exact
///     delta   f(w) + d((1-r) w f)/dw,            first order in 1-r: paper (12)
///
/// With a restitution coefficient r(u) that depends on the impact speed u, the probability flux off
/// the wall is f(u) du/dw at the rebound speed w = u r(u), where f(u) is the flux into the wall.
///
/// The impact conditions `map` and `delta` are computed from differences of the cumulative flux
/// between cell faces, which conserves mass. Interpolation stencils never cross the speed u = 0,
/// where the density is discontinuous.
///
/// @param speed_axis axis of the impact speed u, with cell faces increasing from 0
/// @param impact impact condition, `map` (exact) or `delta` (to first order in 1-r)
AxisOperator impact_map(const GridAxis& speed_axis, const problem::Wall& wall,
                        problem::ImpactCondition impact, int scheme_order);

}  // namespace fpkcheck::fd_fpk
