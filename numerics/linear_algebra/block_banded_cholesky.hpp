#pragma once

#include <Eigen/Core>
#include <vector>

namespace fpkcheck::numerics {

/// A symmetric positive definite matrix of dense blocks, and its Cholesky factor. Blocks more than
/// `bandwidth` blocks from the diagonal are zero. Blocks may differ in size.
class BlockBandedMatrix {
 public:
  BlockBandedMatrix(std::vector<Eigen::Index> block_sizes, int bandwidth);

  Eigen::Index size() const { return offsets_.back(); }
  int blocks() const { return static_cast<int>(offsets_.size()) - 1; }
  Eigen::Index offset(int block) const { return offsets_[block]; }
  /// Block (row, column), column <= row <= column + bandwidth.
  Eigen::Ref<Eigen::MatrixXd> block(int row, int column);

  Eigen::VectorXd diagonal() const;
  /// Replaces A by S A S, S = diag(scale).
  void scale(const Eigen::VectorXd& scale);
  void add_to_diagonal(double value);

  /// Cholesky factorisation A = L L^T, in place.
  bool factorise();
  /// Replaces b by A^-1 b; call factorise() first. Shape of b: (size, any number of columns).
  void solve(Eigen::MatrixXd& b) const;

 private:
  int last(int column) const { return std::min(column + bandwidth_, blocks() - 1); }

  std::vector<Eigen::Index> offsets_;
  int bandwidth_;
  std::vector<Eigen::MatrixXd> columns_;  // each block column: blocks `column` .. last(column)
};

}  // namespace fpkcheck::numerics
