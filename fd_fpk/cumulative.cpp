#include "fd_fpk/cumulative.hpp"

#include <algorithm>

namespace fpkcheck::fd_fpk {

CumulativeInterpolation::CumulativeInterpolation(const Line& line, int points, Beyond beyond_left)
    : line_(line), points_(std::min(points, line.cells() + 1)), beyond_left_(beyond_left) {}

void CumulativeInterpolation::add(double x, double factor,
                                  Eigen::Ref<Eigen::VectorXd> face_weights) const {
  const auto& faces = line_.faces();
  const int last = line_.cells();
  if (x <= faces.front()) return;
  if (x >= faces.back()) {
    face_weights(last) += factor;
    return;
  }
  const auto above = std::upper_bound(faces.begin(), faces.end(), x);
  const int cell = static_cast<int>(above - faces.begin()) - 1;
  int first = cell - (points_ - 1) / 2;
  if (beyond_left_ == Beyond::boundary) first = std::clamp(first, 0, last + 1 - points_);
  for (int a = first; a < first + points_; ++a) {
    if (a <= 0) continue;  // C = 0 there
    double weight = factor;
    for (int b = first; b < first + points_; ++b) {
      if (b != a) weight *= (x - line_.face(b)) / (line_.face(a) - line_.face(b));
    }
    face_weights(std::min(a, last)) += weight;
  }
}

Eigen::VectorXd CumulativeInterpolation::on_averages(
    const Eigen::Ref<const Eigen::VectorXd>& face_weights) const {
  Eigen::VectorXd weights(line_.cells());
  double sum = 0;
  for (int i = line_.cells() - 1; i >= 0; --i) {
    sum += face_weights(i + 1);
    weights(i) = sum * line_.width(i);
  }
  return weights;
}

}  // namespace fpkcheck::fd_fpk
