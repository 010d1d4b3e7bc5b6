#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fd_fpk/axis/axis_operators.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/model.hpp"

namespace fpkcheck::fd_fpk {

/// Interpolates the cumulative distribution C(x) = int_{first face}^x p between the faces of an
/// axis. The cell averages determine C exactly at the faces of the cells. A scheme conserves mass
/// if it computes cell averages as differences of a function of C between the faces of a cell.
class CumulativeInterpolation {
 public:
  static constexpr int kMostPoints = 10;

  /// @param points number of faces in a stencil, up to kMostPoints; the interpolation is exact for
  /// a polynomial density p of degree points - 2
  /// @param left_end condition at the left end of the axis. `boundary`: stencils remain on the
  /// axis; `vacuum`: C = 0 left of the axis. Right of the axis C is constant.
  CumulativeInterpolation(const Axis& axis, int points, EndCondition left_end);

  /// Adds `factor` times the interpolation weights of C(x), one for each face value C_0 .. C_cells,
  /// to `face_weights`.
  void add_weights_at(double x, double factor, Eigen::Ref<Eigen::VectorXd> face_weights) const;

  /// Converts weights of face values to weights of cell averages: C_f is the sum of cell width
  /// times cell average over all cells left of face f.
  Eigen::VectorXd to_average_weights(const Eigen::Ref<const Eigen::VectorXd>& face_weights) const;

 private:
  // The faces around a cell and the inverse denominators 1 / prod_{b != a} (x_a - x_b) of the
  // Lagrange polynomials. The faces and inverse denominators of a stencil are equal for every x in
  // the cell.
  struct Stencil {
    int first;
    std::array<double, kMostPoints> faces;
    std::array<double, kMostPoints> inverse_denominators;
  };

  const Axis& axis_;
  int points_;
  std::vector<Stencil> stencils_;  // shape (cells)
};

/// The impact as a matrix that maps the probability flux into the wall to the flux off the wall.
/// Particles reach x1 = 0 with speed u and flux f(u) = u p(0, -u). The flux off the wall at speed w
/// is
///
///     map     f(w/r)/r,                          p(0+, w) = p(0-, w/r)/r^2: exact
///     delta   f(w) + (1-r) d(w f)/dw,            its first order in 1-r: paper (12)
///
/// The matrix, shape (cells, cells), maps averages of f over the cells of the speed axis to
/// averages of the flux off the wall. The impact conditions `map` and `delta` are computed as
/// differences of a function of the cumulative flux between the faces of a cell, so that any
/// interpolation conserves mass. Stencils never cross u = 0, where the density jumps.
///
/// @param speeds axis of the speeds, with faces increasing from 0
/// @param restitution restitution coefficient r, 0 < r <= 1
/// @param impact map or delta
AxisOperator impact_map(const Axis& speeds, double restitution, problem::Impact impact,
                        int scheme_order);

}  // namespace fpkcheck::fd_fpk
