#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fd_fpk/axis/axis_operators.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/model.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::fd_fpk {

/// Interpolation of the cumulative distribution C(x) = int_{first face}^x p between the faces of an
/// axis. The cell averages of p determine C exactly at the faces. A scheme that computes cell
/// averages from differences of functions of C conserves mass.
class CumulativeDistributionInterpolation {
 public:
  static constexpr int kMostPoints = 10;

  /// @param face_count number of faces in each stencil, at most kMostPoints; the interpolation is
  /// exact for a polynomial density of degree face_count - 2
  /// @param left_end condition at the left end of the axis. With `boundary`, stencils remain on the
  /// axis; with `vacuum`, C = 0 left of the axis. The distribution C is constant right of the axis.
  CumulativeDistributionInterpolation(const Axis& axis, int face_count, AxisEndCondition left_end);

  /// Adds `factor` times the interpolation weights of C(x) to the weights of C_0 .. C_cells.
  void add_interpolation_weights(double x, double factor,
                                 Eigen::Ref<Eigen::VectorXd> face_weights) const;

  /// Converts weights of face values of C to weights of cell averages. The face value C_f is the
  /// sum of cell width times cell average over all cells left of face f.
  Eigen::VectorXd to_average_weights(const Eigen::Ref<const Eigen::VectorXd>& face_weights) const;

 private:
  // Faces around a cell, and 1 / prod_{b != a} (x_a - x_b) for each face a of the stencil.
  struct Stencil {
    int first;
    std::array<double, kMostPoints> faces;
    std::array<double, kMostPoints> inverse_denominators;
  };

  const Axis& axis_;
  int points_;
  std::vector<Stencil> stencils_;  // stencils of all cells of the axis
};

/// Returns the matrix that maps the probability flux into a wall to the flux off the wall, shape
/// (cells, cells). Input and output are averages over the cells of the speed axis. Particles reach
/// x1 = 0 with speed u and flux f(u) = u p(0, -u). The flux off the wall at speed w is
///
///     map     f(w/r)/r,                          p(0+, w) = p(0-, w/r)/r^2: exact
///     delta   f(w) + d((1-r) w f)/dw,            first order in 1-r: paper (12)
///
/// With a restitution coefficient r(u) that depends on the impact speed, the map is f(u) du/dw for
/// w = u r(u).
///
/// Differences of the cumulative flux between faces give the impact conditions `map` and `delta`
/// and conserve mass. Stencils never cross u = 0, where the density is discontinuous.
///
/// @param speed_axis axis of the speed u, with faces increasing from 0
/// @param impact map or delta
AxisOperator impact_map(const Axis& speed_axis, const problem::Wall& wall,
                        problem::ImpactCondition impact, int scheme_order);

}  // namespace fpkcheck::fd_fpk
