#include "fd_fpk/axis/cumulative_interpolation.hpp"

#include <algorithm>

namespace fpkcheck::fd_fpk {

CumulativeInterpolation::CumulativeInterpolation(const Axis& axis, int points,
                                                 EndCondition left_end)
    : axis_(axis), points_(std::min({points, axis.cell_count() + 1, kMostPoints})) {
  stencils_.reserve(axis.cell_count());
  for (int cell = 0; cell < axis.cell_count(); ++cell) {
    Stencil stencil{};
    stencil.first = cell - (points_ - 1) / 2;
    if (left_end == EndCondition::boundary) {
      stencil.first = std::clamp(stencil.first, 0, axis.cell_count() + 1 - points_);
    }
    for (int a = 0; a < points_; ++a) stencil.faces[a] = axis.face_position(stencil.first + a);
    for (int a = 0; a < points_; ++a) {
      double denominator = 1;
      for (int b = 0; b < points_; ++b) {
        if (b != a) denominator *= stencil.faces[a] - stencil.faces[b];
      }
      stencil.inverse_denominators[a] = 1 / denominator;
    }
    stencils_.push_back(stencil);
  }
}

void CumulativeInterpolation::add_weights_at(double x, double factor,
                                             Eigen::Ref<Eigen::VectorXd> face_weights) const {
  const auto& faces = axis_.faces();
  const int last = axis_.cell_count();
  if (x <= faces.front()) return;
  if (x >= faces.back()) {
    face_weights(last) += factor;
    return;
  }
  const auto above = std::upper_bound(faces.begin(), faces.end(), x);
  const Stencil& stencil = stencils_[above - faces.begin() - 1];
  // Lagrange weights: weight_a = prod_{b != a} (x - x_b) / (x_a - x_b), computed as the product
  // over b < a times that over b > a.
  std::array<double, kMostPoints> before;
  double product = factor;
  for (int a = 0; a < points_; ++a) {
    before[a] = product;
    product *= x - stencil.faces[a];
  }
  double after = 1;
  for (int a = points_ - 1; a >= 0; --a) {
    const int face = stencil.first + a;
    if (face <= 0) break;  // C is 0 at the first face and left of the axis
    face_weights(std::min(face, last)) += before[a] * after * stencil.inverse_denominators[a];
    after *= x - stencil.faces[a];
  }
}

Eigen::VectorXd CumulativeInterpolation::to_average_weights(
    const Eigen::Ref<const Eigen::VectorXd>& face_weights) const {
  Eigen::VectorXd weights(axis_.cell_count());
  double sum = 0;
  for (int i = axis_.cell_count() - 1; i >= 0; --i) {
    sum += face_weights(i + 1);
    weights(i) = sum * axis_.cell_width(i);
  }
  return weights;
}

}  // namespace fpkcheck::fd_fpk
