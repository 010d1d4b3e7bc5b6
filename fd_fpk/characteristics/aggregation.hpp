#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <vector>

#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Coarse correction for the chain on cells, by a chain on blocks of neighbouring cells. It removes
/// the slow error components, which take many impulses to decay (aggregation and disaggregation of
/// Markov chains: Koury, McAllister, Stewart, SIAM J. Alg. Disc. Meth. 5, 164 (1984)). Each atom,
/// whose mass follows those of the cells, is a block of its own.
class Aggregation {
 public:
  /// Blocks with about equal numbers of cells, no more than `max_blocks` in total; v = 0 separates
  /// two blocks.
  Aggregation(const Grid& grid, int atoms, int max_blocks);

  /// The grid of the blocks.
  const Grid& blocks() const { return blocks_; }

  /// @param step one step of the chain on masses of the blocks
  void set_block_chain(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// Sets the weights that distribute the mass of a block over its cells: proportional to these
  /// masses, and uniform where they are zero.
  void set_disaggregation_weights(const Eigen::VectorXd& masses);

  /// Replaces the residual r of (1 - A + start 1^T) d = r by an approximate d: the solution on the
  /// blocks, and the residual itself inside each block.
  void correct(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd aggregate(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const Grid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  Grid blocks_;
  Eigen::VectorXd weights_;  // fraction of each cell in the mass of its block
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace fpkcheck::fd_fpk
