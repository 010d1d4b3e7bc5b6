#include "fd_fpk/characteristics/aggregation.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

// The faces of a coarser axis: every `stride`-th face, beginning with the first, and the last face.
std::vector<double> coarsen(const std::vector<double>& faces, int stride) {
  std::vector<double> kept;
  for (std::size_t f = 0; f + 1 < faces.size(); f += static_cast<std::size_t>(stride)) {
    kept.push_back(faces[f]);
  }
  kept.push_back(faces.back());
  return kept;
}

Grid coarsen(const Grid& grid, int stride) {
  return symmetric_grid(coarsen(grid.x1.faces(), stride),
                        coarsen(grid.speed_axis().faces(), stride), grid.x1.left_end_condition(),
                        grid.x1.right_end_condition());
}

int block_stride(const Grid& grid, int max_blocks) {
  int stride = 1;
  const auto count = [&](int cells) { return (cells + stride - 1) / stride; };
  while (count(grid.nx()) * 2 * count(grid.nv() / 2) > max_blocks) ++stride;
  return stride;
}

std::vector<int> block_indices(const Axis& axis, const Axis& blocks) {
  std::vector<int> block(axis.cell_count());
  int b = 0;
  for (int i = 0; i < axis.cell_count(); ++i) {
    while (axis.cell_centre(i) > blocks.face_position(b + 1)) ++b;
    block[i] = b;
  }
  return block;
}

}  // namespace

Aggregation::Aggregation(const Grid& grid, int atom_count, int max_blocks)
    : grid_(grid), atoms_(atom_count), blocks_(coarsen(grid, block_stride(grid, max_blocks))) {
  block_of_y_ = block_indices(grid.x1, blocks_.x1);
  block_of_v_ = block_indices(grid.x2, blocks_.x2);
  set_disaggregation_weights(Eigen::VectorXd::Zero(grid.size() + atom_count));
}

void Aggregation::set_block_chain(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step) {
  const int count = blocks_.size() + atoms_;
  Eigen::MatrixXd system(count, count);
  Eigen::VectorXd one = Eigen::VectorXd::Zero(count);
  for (int b = 0; b < count; ++b) {
    one(b) = 1;
    system.col(b) = one - step(one);
    one(b) = 0;
  }
  // 1 - A is singular. The matrix becomes regular by adding the term start 1^T, here with a start
  // proportional to the areas of the blocks.
  Eigen::VectorXd added = Eigen::VectorXd::Zero(count);
  added.head(blocks_.size()) = blocks_.cell_areas() / blocks_.cell_areas().sum();
  system.colwise() += added;
  factors_.compute(system);
}

void Aggregation::set_disaggregation_weights(const Eigen::VectorXd& masses) {
  constexpr double kEven = 1e-6;  // mass, relative to the total mass, that is distributed evenly
  const Eigen::VectorXd areas = grid_.cell_areas();
  weights_ = masses.cwiseMax(0);
  weights_.head(grid_.size()) += kEven / areas.sum() * areas;
  const Eigen::VectorXd sums = aggregate(weights_);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      weights_(i * grid_.nv() + j) /= sums(block_of_y_[i] * blocks_.nv() + block_of_v_[j]);
    }
  }
}

Eigen::VectorXd Aggregation::aggregate(const Eigen::Ref<const Eigen::VectorXd>& masses) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(blocks_.size() + atoms_);
  sums.tail(atoms_) = masses.tail(atoms_);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      sums(block_of_y_[i] * blocks_.nv() + block_of_v_[j]) += masses(i * grid_.nv() + j);
    }
  }
  return sums;
}

void Aggregation::apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const {
  const Eigen::VectorXd sums = aggregate(masses);
  const Eigen::VectorXd missing = factors_.solve(sums) - sums;
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.nv(); ++j) {
      const int cell = i * grid_.nv() + j;
      masses(cell) += weights_(cell) * missing(block_of_y_[i] * blocks_.nv() + block_of_v_[j]);
    }
  }
  masses.tail(atoms_) += missing.tail(atoms_);
}

}  // namespace fpkcheck::fd_fpk
