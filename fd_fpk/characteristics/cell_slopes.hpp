#pragma once

#include <Eigen/Core>

#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of masses in cells: for a density p + p_y (y - y_c) + p_v (v - v_c) in a cell, the area
/// times p_y and p_v.
struct CellSlopes {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs slopes by central differences of the neighbours' densities, linear in the masses.
/// Slopes are zero in the cells at rest and at the ends of the axes without a wall; at a wall they
/// are one-sided. Masses stored after those of the cells have no slopes.
class SlopeReconstruction {
 public:
  /// @param points rest points, whose cells have no slopes
  SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points);

  CellSlopes operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd v_slopes(const Eigen::VectorXd& masses) const;

  /// Sets limiting factors, which keep the densities of these masses nonnegative inside their
  /// cells: 1 where no limit is needed. The factors are then constant, so that the reconstruction
  /// remains linear.
  void set_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of the lower neighbour, the cell and the upper neighbour.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> weights(const Axis& axis);

  const Grid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // for each cell
  Eigen::VectorXd limits_y_, limits_v_;
};

}  // namespace fpkcheck::fd_fpk
