#pragma once

#include <Eigen/Core>

#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of the density inside cells. For a density p + p_y (y - y_c) + p_v (v - v_c) in a cell
/// the slopes are the area of the cell times p_y and times p_v.
struct CellSlopes {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs the slopes from the masses of the cells, by central differences of the densities in
/// the neighbouring cells. The reconstruction is linear in the masses. At a wall the differences
/// are one-sided. The slopes are zero in the cells of rest points and at ends of the axes that are
/// not walls. Masses stored after those of the cells have no slopes.
class SlopeReconstruction {
 public:
  /// @param points rest points, in whose cells the slopes are zero
  SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points);

  CellSlopes operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd v_slopes(const Eigen::VectorXd& masses) const;

  /// Sets a limiting factor for the slopes of each cell, such that the reconstructed density of
  /// these masses is nonnegative inside the cell. The factor is 1 if no limit is needed. All later
  /// reconstructions use these factors, so that the reconstruction remains linear.
  void set_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of the lower neighbour, the cell and the upper neighbour.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> weights(const Axis& axis);

  const Grid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // whether the cell belongs to a rest point, for each cell
  Eigen::VectorXd limits_y_, limits_v_;
};

}  // namespace fpkcheck::fd_fpk
