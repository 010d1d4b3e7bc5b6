#pragma once

#include "fd_fpk/axis/axis.hpp"
#include "fd_fpk/operator/wall_density.hpp"
#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// Cells on x1 in [x1_min, x1_max], x2 in [-x2_max, x2_max]. With a wall x1_min = 0: in the paper's
/// class this is the half of the (z, z') plane that point symmetry leaves. x2 = 0 lies on a face,
/// and the faces of x2 are symmetric. The unknown is the average of p(y, y') (= 2 p(z, z') of the
/// paper) over each cell; cell (i, j) has index i nv() + j.
struct Grid {
  Axis x1;  ///< its ends of type `boundary` are impact walls
  Axis x2;

  int nx() const { return x1.cells(); }
  int nv() const { return x2.cells(); }  ///< even
  int size() const { return nx() * nv(); }
  double x1_min() const { return x1.faces().front(); }
  double x1_max() const { return x1.faces().back(); }
  double x2_max() const { return x2.faces().back(); }
  /// Areas of the cells, shape (size).
  Eigen::VectorXd areas() const;
  /// Speeds of the half x2 > 0 in increasing order, from 0 upwards.
  Axis speeds() const { return x2.from(nv() / 2); }
};

/// @param positive_x2 faces from 0 upwards; their mirror images are added
/// @param left,right end conditions of x1
Grid symmetric_grid(std::vector<double> x1, const std::vector<double>& positive_x2,
                    EndCondition left = EndCondition::boundary,
                    EndCondition right = EndCondition::vacuum);

/// @param nx,nv numbers of cells in x1 and x2; nv even
Grid make_grid(int nx, int nv, double x1_max, double x2_max, const Grading& x1_grading = {},
               const Grading& x2_grading = {});

/// The density of a vector of cell averages.
transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages);

/// @param reference the peak density to which the result is relative
WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages, double reference);

}  // namespace fpkcheck::fd_fpk
