#pragma once

#include "fd_fpk/axis/axis.hpp"
#include "fd_fpk/operator/wall_density.hpp"
#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// Grid of rectangular cells on x1 in [x1_min, x1_max], x2 in [-x2_max, x2_max]. With a wall x1_min
/// is 0. For the paper's oscillator the grid then covers one half of the (z, z') plane; the density
/// on the other half follows by point symmetry. x2 = 0 is a face, and the faces of x2 are
/// symmetric. The unknown is the average of p(y, y') (= 2 p(z, z') of the paper) over each cell;
/// cell (i, j) has index i nv() + j.
struct Grid {
  Axis x1;  ///< an end with the condition `boundary` is an impact wall
  Axis x2;

  int nx() const { return x1.cell_count(); }
  int nv() const { return x2.cell_count(); }  ///< even
  int size() const { return nx() * nv(); }
  double x1_min() const { return x1.faces().front(); }
  double x1_max() const { return x1.faces().back(); }
  double x2_max() const { return x2.faces().back(); }
  /// Areas of all cells, shape (size).
  Eigen::VectorXd cell_areas() const;
  /// The axis of speeds: the half x2 >= 0 of the velocity axis, in increasing order from 0.
  Axis speed_axis() const { return x2.part_from_face(nv() / 2); }
};

/// @param positive_x2_faces faces of x2 >= 0, increasing from 0; the function adds their mirror
/// images
/// @param left,right end conditions of x1
Grid symmetric_grid(std::vector<double> x1_faces, const std::vector<double>& positive_x2_faces,
                    EndCondition left = EndCondition::boundary,
                    EndCondition right = EndCondition::vacuum);

/// @param nx,nv numbers of cells in x1 and x2; nv even
Grid make_grid(int nx, int nv, double x1_max, double x2_max, const Grading& x1_grading = {},
               const Grading& x2_grading = {});

/// The density on the grid that has the given cell averages.
transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages);

/// @param reference the peak density: the returned wall densities are fractions of this value
WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages, double reference);

}  // namespace fpkcheck::fd_fpk
