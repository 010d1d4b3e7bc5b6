#pragma once

#include <Eigen/Core>
#include <cmath>

#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Cell averages of a function by 3 x 3 Gauss points per cell, the unknowns of the operator.
template <class Function>
Eigen::VectorXd three_point_averages(const Grid& grid, const Function& f) {
  const double node = std::sqrt(0.6) / 2, weight[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  Eigen::VectorXd averages = Eigen::VectorXd::Zero(grid.size());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.nv(); ++j) {
      for (int a = -1; a <= 1; ++a) {
        for (int b = -1; b <= 1; ++b) {
          averages(i * grid.nv() + j) +=
              weight[a + 1] * weight[b + 1] *
              f(grid.x1.cell_centre(i) + a * node * grid.x1.cell_width(i),
                grid.x2.cell_centre(j) + b * node * grid.x2.cell_width(j));
        }
      }
    }
  }
  return averages;
}

}  // namespace fpkcheck::fd_fpk
