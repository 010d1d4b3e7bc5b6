#include "fd_fpk/axis/axis.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace fpkcheck::fd_fpk {

Axis::Axis(std::vector<double> faces, EndCondition left, EndCondition right)
    : faces_(std::move(faces)), left_(left), right_(right) {}

Axis Axis::with_uniform_cells(double origin, double step, int cells, EndCondition left) {
  std::vector<double> faces(cells + 1);
  for (int f = 0; f <= cells; ++f) faces[f] = origin + f * step;
  return Axis(std::move(faces), left);
}

double Axis::face_position(int f) const {
  const int last = cell_count();
  if (f < 0) return faces_.front() + f * (faces_[1] - faces_[0]);
  if (f > last) return faces_.back() + (f - last) * (faces_[last] - faces_[last - 1]);
  return faces_[f];
}

double Axis::smallest_cell_width() const { return cell_widths().minCoeff(); }

Eigen::VectorXd Axis::cell_widths() const {
  Eigen::VectorXd widths(cell_count());
  for (int i = 0; i < cell_count(); ++i) widths(i) = cell_width(i);
  return widths;
}

Axis Axis::part_from_face(int first_face) const {
  return Axis(std::vector<double>(faces_.begin() + first_face, faces_.end()));
}

double graded_cell_count(double length, double step, const Grading& grading) {
  return (length + grading.reach * std::log1p(length / grading.core)) / step;
}

std::vector<double> graded_faces(double length, int cells, const Grading& grading) {
  const double total = graded_cell_count(length, 1.0, grading);
  std::vector<double> faces(cells + 1);
  for (int f = 1; f < cells; ++f) {
    faces[f] = length * f / cells;
    if (grading.reach == 0) continue;
    const double wanted = total * f / cells;
    const auto excess = [&](double x) {
      return std::pair{graded_cell_count(x, 1.0, grading) - wanted,
                       1 + grading.reach / (grading.core + x)};
    };
    faces[f] =
        boost::math::tools::newton_raphson_iterate(excess, faces[f - 1], faces[f - 1], length, 50);
  }
  faces[cells] = length;
  return faces;
}

std::vector<double> faces_graded_to_points(double from, double to, double step,
                                           std::span<const RefinementPoint> refinement_points) {
  // The number of cells up to x, apart from an additive constant.
  const auto cells_to = [&](double x) {
    double cells = x;
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

}  // namespace fpkcheck::fd_fpk
