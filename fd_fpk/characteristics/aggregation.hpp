#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <vector>

#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Coarse correction for the embedded Markov chain on cells, by a chain on blocks of neighbouring
/// cells. The correction removes the slow error components, which decay over many impulses
/// (aggregation and disaggregation of Markov chains: Koury, McAllister, Stewart, SIAM J. Alg. Disc.
/// Meth. 5, 164 (1984)). Each atom is a block of its own; in all vectors the masses of the atoms
/// follow those of the cells.
class Aggregation {
 public:
  /// Divides the grid into at most `max_blocks` blocks with about equal numbers of cells; v = 0
  /// separates two blocks.
  Aggregation(const Grid& grid, int atom_count, int max_blocks);

  /// The grid whose cells are the blocks.
  const Grid& block_grid() const { return blocks_; }

  /// @param step function that applies one step of the chain to the masses of the blocks
  void set_block_chain(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// Sets the weights that distribute the mass of a block over its cells: proportional to these
  /// masses, and uniform in blocks whose masses are zero.
  void set_disaggregation_weights(const Eigen::VectorXd& masses);

  /// Replaces the residual r of (1 - A + start 1^T) d = r by an approximate d: d is the solution of
  /// the equation for the blocks, distributed over cells by the weights, plus the part of r whose
  /// sum over each block is zero.
  void apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd aggregate(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const Grid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  Grid blocks_;
  Eigen::VectorXd weights_;  // fraction that each cell has of the mass of its block
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace fpkcheck::fd_fpk
