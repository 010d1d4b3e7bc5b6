#include "fd_fpk/operator/grid.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::fd_fpk {

Eigen::VectorXd Grid::cell_areas() const {
  Eigen::VectorXd areas(size());
  Eigen::Map<Eigen::MatrixXd>(areas.data(), nv(), nx()) =
      x2.cell_widths() * x1.cell_widths().transpose();
  return areas;
}

Grid symmetric_grid(std::vector<double> x1, const std::vector<double>& positive_x2,
                    EndCondition left, EndCondition right) {
  std::vector<double> x2;  // the face 0 occurs once, as +0
  for (auto f = positive_x2.rbegin(); f + 1 != positive_x2.rend(); ++f) x2.push_back(-*f);
  x2.insert(x2.end(), positive_x2.begin(), positive_x2.end());
  return {Axis(std::move(x1), left, right), Axis(std::move(x2))};
}

Grid make_grid(int nx, int nv, double x1_max, double x2_max, const Grading& x1_grading,
               const Grading& x2_grading) {
  return symmetric_grid(graded_faces(x1_max, nx, x1_grading),
                        graded_faces(x2_max, nv / 2, x2_grading));
}

transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages) {
  return {grid.x1.faces(), grid.x2.faces(), {averages.begin(), averages.end()}};
}

WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages, double reference) {
  WallDensity wall{0, 0};
  const Eigen::Index nx = grid.nx(), nv = grid.nv();
  const bool open_left = grid.x1.left_end_condition() == EndCondition::vacuum;
  const bool open_right = grid.x1.right_end_condition() == EndCondition::vacuum;
  for (Eigen::Index j = 0; j < nv; ++j) {
    if (open_right) wall.x1 = std::max(wall.x1, std::abs(averages((nx - 1) * nv + j)));
    if (open_left) wall.x1_low = std::max(wall.x1_low, std::abs(averages(j)));
  }
  for (Eigen::Index i = 0; i < nx; ++i) {
    wall.x2 = std::max({wall.x2, std::abs(averages(i * nv)), std::abs(averages((i + 1) * nv - 1))});
  }
  return {wall.x1 / reference, wall.x2 / reference, wall.x1_low / reference};
}

}  // namespace fpkcheck::fd_fpk
