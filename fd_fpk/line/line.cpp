#include "fd_fpk/line/line.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace fpkcheck::fd_fpk {

Line::Line(std::vector<double> faces, Beyond left) : faces_(std::move(faces)), left_(left) {}

Line Line::uniform(double origin, double step, int cells, Beyond left) {
  std::vector<double> faces(cells + 1);
  for (int f = 0; f <= cells; ++f) faces[f] = origin + f * step;
  return Line(std::move(faces), left);
}

double Line::face(int f) const {
  const int last = cells();
  if (f < 0) return faces_.front() + f * (faces_[1] - faces_[0]);
  if (f > last) return faces_.back() + (f - last) * (faces_[last] - faces_[last - 1]);
  return faces_[f];
}

double Line::smallest_width() const { return widths().minCoeff(); }

Eigen::VectorXd Line::widths() const {
  Eigen::VectorXd widths(cells());
  for (int i = 0; i < cells(); ++i) widths(i) = width(i);
  return widths;
}

Line Line::from(int first_face) const {
  return Line(std::vector<double>(faces_.begin() + first_face, faces_.end()));
}

double graded_cells(double length, double step, const Grading& grading) {
  return (length + grading.reach * std::log1p(length / grading.core)) / step;
}

std::vector<double> graded_faces(double length, int cells, const Grading& grading) {
  const double total = graded_cells(length, 1.0, grading);
  std::vector<double> faces(cells + 1);
  for (int f = 1; f < cells; ++f) {
    faces[f] = length * f / cells;
    if (grading.reach == 0) continue;
    const double wanted = total * f / cells;
    const auto excess = [&](double x) {
      return std::pair{graded_cells(x, 1.0, grading) - wanted,
                       1 + grading.reach / (grading.core + x)};
    };
    faces[f] =
        boost::math::tools::newton_raphson_iterate(excess, faces[f - 1], faces[f - 1], length, 50);
  }
  faces[cells] = length;
  return faces;
}

}  // namespace fpkcheck::fd_fpk
