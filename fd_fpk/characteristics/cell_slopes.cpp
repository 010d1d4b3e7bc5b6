#include "fd_fpk/characteristics/cell_slopes.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {

// Weights of the masses m_i in the slope of each cell. The slope is that of the parabola through
// the densities m_i / h_i at the centres of three cells, at the centre of the middle cell, times h.
std::vector<SlopeReconstruction::Weights> SlopeReconstruction::weights(const Axis& axis) {
  std::vector<Weights> weights(axis.cell_count(), Weights{0, 0, 0});
  for (int i = 0; i < axis.cell_count(); ++i) {
    const double h = axis.cell_width(i);
    if (i > 0 && i + 1 < axis.cell_count()) {
      const double before = axis.cell_centre(i) - axis.cell_centre(i - 1);
      const double after = axis.cell_centre(i + 1) - axis.cell_centre(i);
      const double below = -after / (before * (before + after));
      const double above = before / (after * (before + after));
      weights[i] = {h * below / axis.cell_width(i - 1), -(below + above),
                    h * above / axis.cell_width(i + 1)};
    } else if (i == 0 && axis.left_end_condition() == EndCondition::boundary &&
               axis.cell_count() > 1) {
      const double slope = 1 / (axis.cell_centre(1) - axis.cell_centre(0));
      weights[i] = {0, -slope, h * slope / axis.cell_width(1)};
    } else if (i > 0 && axis.right_end_condition() == EndCondition::boundary) {
      const double slope = 1 / (axis.cell_centre(i) - axis.cell_centre(i - 1));
      weights[i] = {-h * slope / axis.cell_width(i - 1), slope, 0};
    }
  }
  return weights;
}

SlopeReconstruction::SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points)
    : grid_(grid),
      of_y_(weights(grid.x1)),
      of_v_(weights(grid.x2)),
      at_rest_(static_cast<std::size_t>(grid.size()), false),
      limits_y_(Eigen::VectorXd::Ones(grid.size())),
      limits_v_(Eigen::VectorXd::Ones(grid.size())) {
  for (const RestPoint& point : points) {
    for (const auto& [cell, share] : point.cells) at_rest_[cell] = true;
  }
}

Eigen::VectorXd SlopeReconstruction::v_slopes(const Eigen::VectorXd& masses) const {
  const int nv = grid_.nv();
  Eigen::VectorXd slopes(grid_.size());
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      const auto& [below, centre, above] = of_v_[j];
      double slope = centre * masses(cell);
      if (j > 0) slope += below * masses(cell - 1);
      if (j + 1 < nv) slope += above * masses(cell + 1);
      slopes(cell) = at_rest_[cell] ? 0 : limits_v_(cell) * slope;
    }
  }
  return slopes;
}

CellSlopes SlopeReconstruction::operator()(const Eigen::VectorXd& masses) const {
  const int nx = grid_.nx(), nv = grid_.nv();
  CellSlopes slopes{.y = Eigen::VectorXd(grid_.size()), .v = v_slopes(masses)};
  for (int i = 0; i < nx; ++i) {
    const auto& [below, centre, above] = of_y_[i];
    for (int j = 0; j < nv; ++j) {
      const int cell = i * nv + j;
      double slope = centre * masses(cell);
      if (i > 0) slope += below * masses(cell - nv);
      if (i + 1 < nx) slope += above * masses(cell + nv);
      slopes.y(cell) = at_rest_[cell] ? 0 : limits_y_(cell) * slope;
    }
  }
  return slopes;
}

void SlopeReconstruction::set_limiter(const Eigen::VectorXd& masses) {
  limits_y_.setOnes();
  limits_v_.setOnes();
  const auto [y, v] = (*this)(masses);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      const int cell = i * grid_.nv() + j;
      // Largest decrease of the density from the centre to a corner of the cell, relative to the
      // mean density of the cell.
      const double dip = (std::abs(y(cell)) * grid_.x1.cell_width(i) +
                          std::abs(v(cell)) * grid_.x2.cell_width(j)) /
                         2;
      const double mass = std::max(masses(cell), 0.0);
      if (dip > mass) limits_y_(cell) = limits_v_(cell) = mass / dip;
    }
  }
}

}  // namespace fpkcheck::fd_fpk
