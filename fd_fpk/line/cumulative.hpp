#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fd_fpk/line/line.hpp"

namespace fpkcheck::fd_fpk {

/// Interpolates the cumulative C(x) = int_{first face}^x p between the faces of a line, where cell
/// averages give it exactly. Whatever is done with C, differences of it over the cells keep mass.
class CumulativeInterpolation {
 public:
  static constexpr int kMostPoints = 10;

  /// @param points faces a stencil, up to kMostPoints: exact for p of degree points - 2
  /// @param beyond_left boundary: stencils stay on the line; vacuum: C = 0 before it. After the
  ///        line C is constant.
  CumulativeInterpolation(const Line& line, int points, Beyond beyond_left);

  /// Adds `factor` times the weights of the face values C_0 .. C_cells in C(x).
  void add(double x, double factor, Eigen::Ref<Eigen::VectorXd> face_weights) const;

  /// The weights of cell averages that stand for weights of face values: C_f is the sum of width
  /// times average over the cells before face f.
  Eigen::VectorXd on_averages(const Eigen::Ref<const Eigen::VectorXd>& face_weights) const;

 private:
  // The faces around a cell and 1 / prod_{b != a} (x_a - x_b), the Lagrange polynomials'
  // denominators: they are the same for every x in the cell.
  struct Stencil {
    int first;
    std::array<double, kMostPoints> faces;
    std::array<double, kMostPoints> inverse_denominators;
  };

  const Line& line_;
  int points_;
  std::vector<Stencil> stencils_;  // shape (cells)
};

}  // namespace fpkcheck::fd_fpk
