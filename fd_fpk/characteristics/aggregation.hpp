#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <vector>

#include "fd_fpk/operator/grid.hpp"

namespace fpkcheck::fd_fpk {

/// Blocks of neighbouring cells, and what a chain on blocks tells of one on cells: the slow part of
/// an error, which takes many impulses to decay (aggregation and disaggregation of Markov chains:
/// Koury, McAllister, Stewart, SIAM J. Alg. Disc. Meth. 5, 164 (1984)). Atoms, whose masses follow
/// those of the cells, are blocks by themselves.
class Aggregation {
 public:
  /// Blocks of about as many cells, together no more than `most`; v = 0 stays between two.
  Aggregation(const Grid& grid, int atoms, int most);

  /// The grid of the blocks.
  const Grid& blocks() const { return blocks_; }

  /// @param step one step of the chain on masses of the blocks
  void set_chain(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// How masses of a block spread over its cells: like these, and evenly where they are none.
  void spread_like(const Eigen::VectorXd& masses);

  /// Replaces the residual r of (1 - A + start 1^T) d = r by an approximate d: on the blocks solved,
  /// within them left as it is.
  void correct(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd aggregated(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const Grid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  Grid blocks_;
  Eigen::VectorXd weights_;  // of the cells in their block
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace fpkcheck::fd_fpk
