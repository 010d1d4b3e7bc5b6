#include "fd_fpk/characteristics/tilts.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {

// With densities m_i / h_i at the centres: the slope at a cell's centre of the parabola through
// three of them, times h, in terms of masses.
std::vector<TiltRule::Weights> TiltRule::weights(const Line& line) {
  std::vector<Weights> weights(line.cells(), Weights{0, 0, 0});
  for (int i = 0; i < line.cells(); ++i) {
    const double h = line.width(i);
    if (i > 0 && i + 1 < line.cells()) {
      const double before = line.centre(i) - line.centre(i - 1);
      const double after = line.centre(i + 1) - line.centre(i);
      const double below = -after / (before * (before + after));
      const double above = before / (after * (before + after));
      weights[i] = {h * below / line.width(i - 1), -(below + above), h * above / line.width(i + 1)};
    } else if (i == 0 && line.left() == Beyond::boundary && line.cells() > 1) {
      const double slope = 1 / (line.centre(1) - line.centre(0));
      weights[i] = {0, -slope, h * slope / line.width(1)};
    } else if (i > 0 && line.right() == Beyond::boundary) {
      const double slope = 1 / (line.centre(i) - line.centre(i - 1));
      weights[i] = {-h * slope / line.width(i - 1), slope, 0};
    }
  }
  return weights;
}

TiltRule::TiltRule(const Grid& grid, const std::vector<RestPlace>& places)
    : grid_(grid),
      of_y_(weights(grid.x1)),
      of_v_(weights(grid.x2)),
      at_rest_(static_cast<std::size_t>(grid.size()), false),
      limits_y_(Eigen::VectorXd::Ones(grid.size())),
      limits_v_(Eigen::VectorXd::Ones(grid.size())) {
  for (const RestPlace& place : places) {
    for (const auto& [cell, share] : place.cells) at_rest_[cell] = true;
  }
}

Eigen::VectorXd TiltRule::in_v(const Eigen::VectorXd& masses) const {
  const int nv = grid_.nv();
  Eigen::VectorXd tilts(grid_.size());
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      const auto& [below, own, above] = of_v_[j];
      double tilt = own * masses(cell);
      if (j > 0) tilt += below * masses(cell - 1);
      if (j + 1 < nv) tilt += above * masses(cell + 1);
      tilts(cell) = at_rest_[cell] ? 0 : limits_v_(cell) * tilt;
    }
  }
  return tilts;
}

Tilts TiltRule::operator()(const Eigen::VectorXd& masses) const {
  const int nx = grid_.nx(), nv = grid_.nv();
  Tilts tilts{.y = Eigen::VectorXd(grid_.size()), .v = in_v(masses)};
  for (int i = 0; i < nx; ++i) {
    const auto& [below, own, above] = of_y_[i];
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      double tilt = own * masses(cell);
      if (i > 0) tilt += below * masses(cell - nv);
      if (i + 1 < nx) tilt += above * masses(cell + nv);
      tilts.y(cell) = at_rest_[cell] ? 0 : limits_y_(cell) * tilt;
    }
  }
  return tilts;
}

void TiltRule::limit_by(const Eigen::VectorXd& masses) {
  limits_y_.setOnes();
  limits_v_.setOnes();
  const auto [y, v] = (*this)(masses);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      const int cell = i * grid_.nv() + j;
      // Largest decrease of the density in a corner of the cell, relative to its mean.
      const double dip =
          (std::abs(y(cell)) * grid_.x1.width(i) + std::abs(v(cell)) * grid_.x2.width(j)) / 2;
      const double mass = std::max(masses(cell), 0.0);
      if (dip > mass) limits_y_(cell) = limits_v_(cell) = mass / dip;
    }
  }
}

}  // namespace fpkcheck::fd_fpk
