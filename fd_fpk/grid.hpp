#pragma once

#include "fd_fpk/line_operators.hpp"
#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// Uniform cells on x1 in [0, x1_max], x2 in [-x2_max, x2_max]: the half of the (z, z') plane that
/// point symmetry leaves. x1 = 0 and x2 = 0 lie on faces. The unknown is the average of
/// p(y, y') = 2 p(z, z') over each cell; cell (i, j) has index i nv + j.
struct Grid {
  int nx;
  int nv;  ///< even
  double x1_max;
  double x2_max;

  UniformLine x1() const { return {0.0, x1_max / nx, nx, Beyond::boundary}; }
  UniformLine x2() const { return {-x2_max, 2 * x2_max / nv, nv}; }
  int size() const { return nx * nv; }
  double cell_area() const { return x1().step * x2().step; }
};

/// The density that an unknown vector on the grid stands for.
transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages);

/// The largest density in the cells along the outer x1 wall and along the two x2 walls, relative to
/// the largest of all.
struct WallDensity {
  double x1;
  double x2;
};
WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages);

}  // namespace fpkcheck::fd_fpk
