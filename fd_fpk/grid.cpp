#include "fd_fpk/grid.hpp"

#include <algorithm>

namespace fpkcheck::fd_fpk {
namespace {

std::vector<double> faces(const UniformLine& line) {
  std::vector<double> edges(line.cells + 1);
  for (int f = 0; f <= line.cells; ++f) edges[f] = line.face(f);
  return edges;
}

}  // namespace

transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages) {
  return {faces(grid.x1()), faces(grid.x2()), {averages.begin(), averages.end()}};
}

WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages) {
  WallDensity wall{0, 0};
  for (int j = 0; j < grid.nv; ++j) {
    wall.x1 = std::max(wall.x1, std::abs(averages((grid.nx - 1) * grid.nv + j)));
  }
  for (int i = 0; i < grid.nx; ++i) {
    wall.x2 = std::max(
        {wall.x2, std::abs(averages(i * grid.nv)), std::abs(averages((i + 1) * grid.nv - 1))});
  }
  const double peak = averages.cwiseAbs().maxCoeff();
  return {wall.x1 / peak, wall.x2 / peak};
}

}  // namespace fpkcheck::fd_fpk
