#pragma once

#include <Eigen/Core>

#include "fd_fpk/characteristics/rest.hpp"
#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// How masses on cells lean: of a density p + p_y (y - y_c) + p_v (v - v_c) in a cell, the area
/// times p_y and p_v.
struct Tilts {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Tilts by central differences of the densities of neighbours, linear in the masses; none in the
/// cells at rest, nor at the ends of the lines but for walls, where the neighbour in front of them
/// tells. What follows the masses of the cells has none.
class TiltRule {
 public:
  /// @param places whose cells are at rest
  TiltRule(const Grid& grid, const std::vector<RestPlace>& places);

  Tilts operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd in_v(const Eigen::VectorXd& masses) const;

  /// From now on tilts are smaller by the factors that keep these masses' densities from being
  /// negative anywhere in their cells: 1 where they are not. Frozen, so that the rule stays linear.
  void limit_by(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of the neighbour below, the cell and the neighbour above.
  struct Weights {
    double below, own, above;
  };
  static std::vector<Weights> weights(const Line& line);

  const Grid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // by cell
  Eigen::VectorXd limits_y_, limits_v_;
};

}  // namespace fpkcheck::fd_fpk
