#include "fd_fpk/functionals/density_interpolation.hpp"

#include <algorithm>

#include "numerics/chebyshev_interpolation.hpp"

namespace fpkcheck::fd_fpk {

DensityInterpolation::DensityInterpolation(const PhasePlaneGrid& grid,
                                           const Eigen::VectorXd& averages)
    : grid_(grid) {
  const Eigen::Map<const Eigen::MatrixXd> p(averages.data(), grid.v_cell_count(), grid.nx());
  cumulative_ = Eigen::MatrixXd::Zero(grid.v_cell_count() + 1, grid.nx() + 1);
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      const double mass = p(j, i) * grid.x1.cell_width(i) * grid.x2.cell_width(j);
      cumulative_(j + 1, i + 1) =
          cumulative_(j, i + 1) + cumulative_(j + 1, i) - cumulative_(j, i) + mass;
    }
  }
}

double DensityInterpolation::operator()(double y, double v) const {
  const auto of_y = derivative_weights(grid_.x1.faces(), y),
             of_v = derivative_weights(grid_.x2.faces(), v);
  if (of_y.weights.empty() || of_v.weights.empty()) return 0;
  double density = 0;
  for (std::size_t a = 0; a < of_y.weights.size(); ++a) {
    for (std::size_t b = 0; b < of_v.weights.size(); ++b) {
      density += of_y.weights[a] * of_v.weights[b] *
                 cumulative_(of_v.first + static_cast<Eigen::Index>(b),
                             of_y.first + static_cast<Eigen::Index>(a));
    }
  }
  return density;
}

DensityInterpolation::FaceWeights DensityInterpolation::derivative_weights(
    std::span<const double> faces, double x) {
  constexpr std::ptrdiff_t kFaces = 6;
  if (x < faces.front() || x > faces.back()) return {};
  const auto size = static_cast<std::ptrdiff_t>(faces.size());
  const std::ptrdiff_t first =
      std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(faces, x) - faces.begin() - kFaces / 2, 0,
                                 std::max<std::ptrdiff_t>(0, size - kFaces));
  const auto near = faces.subspan(static_cast<std::size_t>(first),
                                  static_cast<std::size_t>(std::min(size, kFaces)));
  return {first, numerics::lagrange_derivative_weights(near, x, 1)};
}

}  // namespace fpkcheck::fd_fpk
