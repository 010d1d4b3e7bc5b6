#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fd_fpk/axis/axis.hpp"

namespace fpkcheck::fd_fpk {

/// Interpolates the cumulative C(x) = int_{first face}^x p between the faces of an axis, where cell
/// averages determine C exactly. Differences over cells of any function of C conserve mass.
class CumulativeInterpolation {
 public:
  static constexpr int kMostPoints = 10;

  /// @param points faces in a stencil, up to kMostPoints: exact for p of degree points - 2
  /// @param left_end boundary: stencils remain on the axis; vacuum: C = 0 left of the axis.
  /// Right of the axis C is constant.
  CumulativeInterpolation(const Axis& axis, int points, EndCondition left_end);

  /// Adds `factor` times the weights of the face values C_0 .. C_cells in C(x).
  void add(double x, double factor, Eigen::Ref<Eigen::VectorXd> face_weights) const;

  /// Converts weights of face values to weights of cell averages: C_f is the sum of width times
  /// average over the cells left of face f.
  Eigen::VectorXd to_average_weights(const Eigen::Ref<const Eigen::VectorXd>& face_weights) const;

 private:
  // The faces around a cell and the inverse denominators 1 / prod_{b != a} (x_a - x_b) of the
  // Lagrange polynomials, which are the same for every x in the cell.
  struct Stencil {
    int first;
    std::array<double, kMostPoints> faces;
    std::array<double, kMostPoints> inverse_denominators;
  };

  const Axis& axis_;
  int points_;
  std::vector<Stencil> stencils_;  // shape (cells)
};

}  // namespace fpkcheck::fd_fpk
