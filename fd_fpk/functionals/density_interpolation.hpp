#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fd_fpk/axis/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Point values of a density from its cell averages, as derivatives of the cumulative distribution.
class DensityInterpolation {
 public:
  /// @param grid must outlive this object
  DensityInterpolation(const PhasePlaneGrid& grid, const Eigen::VectorXd& averages);

  /// Returns the density at a point; 0 outside the grid.
  double operator()(double y, double v) const;

 private:
  struct FaceWeights {
    Eigen::Index first = 0;
    std::vector<double> weights = {};
  };
  static FaceWeights derivative_weights(std::span<const double> faces, double x);

  const PhasePlaneGrid& grid_;
  Eigen::MatrixXd cumulative_;  // at the faces, shape (nv + 1, nx + 1)
};

}  // namespace fpkcheck::fd_fpk
