#include "fd_fpk/axis/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fpkcheck::fd_fpk {

GridAxis::GridAxis(std::vector<double> faces, AxisEndCondition left, AxisEndCondition right)
    : faces_(std::move(faces)), left_(left), right_(right) {}

GridAxis GridAxis::with_uniform_cells(double origin, double cell_width, int cell_count,
                                      AxisEndCondition left_end_condition) {
  std::vector<double> faces(cell_count + 1);
  for (int f = 0; f <= cell_count; ++f) faces[f] = origin + f * cell_width;
  return GridAxis(std::move(faces), left_end_condition);
}

double GridAxis::face_position(int face) const {
  const int last = cell_count();
  if (face < 0) return faces_.front() + face * (faces_[1] - faces_[0]);
  if (face > last) return faces_.back() + (face - last) * (faces_[last] - faces_[last - 1]);
  return faces_[face];
}

double GridAxis::smallest_cell_width() const { return cell_widths().minCoeff(); }

Eigen::VectorXd GridAxis::cell_widths() const {
  Eigen::VectorXd widths(cell_count());
  for (int i = 0; i < cell_count(); ++i) widths(i) = cell_width(i);
  return widths;
}

GridAxis GridAxis::subaxis_above_face(int first_face) const {
  return GridAxis(std::vector<double>(faces_.begin() + first_face, faces_.end()));
}

double graded_cell_count(double length, double step, const CellGrading& grading) {
  return (length + grading.reach * std::log1p(length / grading.core)) / step;
}

std::vector<double> graded_cell_faces(double length, int cells, const CellGrading& grading) {
  // With exactly uniform cell faces the stencil weights that are 0 in exact arithmetic are also 0
  // in floating-point arithmetic, so that the operator matrix is sparse.
  std::vector<double> uniform(cells + 1);
  for (int f = 0; f <= cells; ++f) uniform[f] = length * f / cells;
  if (grading.reach == 0) return uniform;
  const std::array origin{RefinementPoint{0, grading}};
  // The factor 1 + 1e-12 prevents an additional cell due to rounding errors.
  const double step = graded_cell_count(length, 1, grading) / cells * (1 + 1e-12);
  return cell_faces_graded_to_points(0, length, step, origin);
}

std::vector<double> cell_faces_graded_to_points(double from, double to, double step,
                                                std::span<const RefinementPoint> refinement_points,
                                                const std::function<double(double)>& stretched) {
  // Returns the number of grid cells below the position x, apart from an additive constant.
  const auto cells_to = [&](double x) {
    double cells = stretched(x);
    for (const auto& [centre, grading] : refinement_points) {
      cells += std::copysign(grading.reach * std::log1p(std::abs(x - centre) / grading.core),
                             x - centre);
    }
    return cells / step;
  };
  std::vector<double> ends{from};
  for (const RefinementPoint& centre : refinement_points) {
    if (centre.x > ends.back() && centre.x < to) ends.push_back(centre.x);
  }
  if (to > ends.back()) ends.push_back(to);
  std::vector<double> faces{from};
  for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
    const double first = cells_to(ends[n]), last = cells_to(ends[n + 1]);
    const int count = std::max(1, static_cast<int>(std::ceil(last - first - 1e-9)));
    for (int k = 1; k < count; ++k) {
      const double wanted = first + (last - first) * k / count;
      // On a symmetric axis, bisection places a cell face at exactly x = 0. The class
      // ConservativeRemap treats a cell face at x = 0 as a special case.
      double below = faces.back(), above = ends[n + 1];
      for (int bisection = 0; bisection < 60; ++bisection) {
        const double middle = (below + above) / 2;
        (cells_to(middle) < wanted ? below : above) = middle;
      }
      faces.push_back((below + above) / 2);
    }
    faces.push_back(ends[n + 1]);
  }
  return faces;
}

std::vector<double> cell_faces_from_width_function(std::span<const double> anchors,
                                                   const std::function<double(double)>& width) {
  constexpr double kStepFraction =
      0.05;  // fraction of a cell over which the cell width is nearly constant
  std::vector<double> faces{anchors.front()};
  std::vector<double> x, cells;  // cells[k] is the number of cells below x[k]
  for (std::size_t n = 0; n + 1 < anchors.size(); ++n) {
    const double from = anchors[n], to = anchors[n + 1];
    x.assign(1, from);
    cells.assign(1, 0);
    while (x.back() < to) {
      // The integration step along the axis is a fraction of the smaller cell width at the two ends
      // of the step.
      double step = kStepFraction * width(x.back());
      step = std::min(step, kStepFraction * width(std::min(to, x.back() + step)));
      const double next = x.back() + step < to ? x.back() + step : to;
      cells.push_back(cells.back() + (next - x.back()) / width((x.back() + next) / 2));
      x.push_back(next);
    }
    const int count = std::max(1, static_cast<int>(std::ceil(cells.back() - 1e-9)));
    std::size_t k = 0;
    for (int f = 1; f < count; ++f) {
      const double wanted = cells.back() * f / count;
      while (cells[k + 1] < wanted) ++k;
      const double part = (wanted - cells[k]) / (cells[k + 1] - cells[k]);
      faces.push_back(x[k] + part * (x[k + 1] - x[k]));
    }
    faces.push_back(to);
  }
  return faces;
}

Eigen::VectorXd PhasePlaneGrid::cell_areas() const {
  Eigen::VectorXd areas(size());
  Eigen::Map<Eigen::MatrixXd>(areas.data(), v_cell_count(), nx()) =
      x2.cell_widths() * x1.cell_widths().transpose();
  return areas;
}

PhasePlaneGrid symmetric_grid(std::vector<double> x1, const std::vector<double>& positive_x2,
                              AxisEndCondition left, AxisEndCondition right) {
  std::vector<double> x2;  // x2 contains the face 0 once, as +0
  for (auto f = positive_x2.rbegin(); f + 1 != positive_x2.rend(); ++f) x2.push_back(-*f);
  x2.insert(x2.end(), positive_x2.begin(), positive_x2.end());
  return {GridAxis(std::move(x1), left, right), GridAxis(std::move(x2))};
}

PhasePlaneGrid make_grid(int nx, int nv, double x1_max, double x2_max,
                         const CellGrading& x1_grading, const CellGrading& x2_grading) {
  return symmetric_grid(graded_cell_faces(x1_max, nx, x1_grading),
                        graded_cell_faces(x2_max, nv / 2, x2_grading));
}

transform::GridDensity grid_density_from_averages(const PhasePlaneGrid& grid,
                                                  const Eigen::VectorXd& cell_averages) {
  return {grid.x1.faces(), grid.x2.faces(), {cell_averages.begin(), cell_averages.end()}};
}

BoxEdgeDensity box_edge_density(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                                double peak_density) {
  BoxEdgeDensity wall{0, 0};
  const Eigen::Index nx = grid.nx(), nv = grid.v_cell_count();
  const bool open_left = grid.x1.left_end_condition() == AxisEndCondition::vacuum;
  const bool open_right = grid.x1.right_end_condition() == AxisEndCondition::vacuum;
  for (Eigen::Index j = 0; j < nv; ++j) {
    if (open_right) wall.x1 = std::max(wall.x1, std::abs(cell_averages((nx - 1) * nv + j)));
    if (open_left) wall.x1_low = std::max(wall.x1_low, std::abs(cell_averages(j)));
  }
  for (Eigen::Index i = 0; i < nx; ++i) {
    wall.x2 = std::max(
        {wall.x2, std::abs(cell_averages(i * nv)), std::abs(cell_averages((i + 1) * nv - 1))});
  }
  return {wall.x1 / peak_density, wall.x2 / peak_density, wall.x1_low / peak_density};
}

}  // namespace fpkcheck::fd_fpk
