#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace fpkcheck::numerics {

/// LU factors of a sparse matrix whose dense blocks of equal size lie near the diagonal, without
/// exchanges of rows between blocks. The factors fill the envelope: in each column of blocks down to
/// the last nonzero block of this and all earlier columns, in each row likewise to the right. A
/// matrix s - L of a generator L with s > 0 needs no exchanges.
class BlockBandedLu {
 public:
  /// @pre the size of the matrix is a multiple of block_size
  BlockBandedLu(const Eigen::SparseMatrix<double>& matrix, int block_size);

  /// Replaces b by A^-1 b.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;
  /// Replaces b by A^-T b.
  void solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

  /// Returns whether all factors are finite, that is, whether every diagonal block was regular.
  bool is_finite() const;

  /// Returns the number of elements of the factors of a matrix with blocks up to `reach` blocks from
  /// the diagonal, for a choice of the method by memory.
  static double element_count(double size, double block_size, int reach) {
    return size * block_size * (1 + 2 * reach);
  }

 private:
  Eigen::Index first_row(int block) const { return static_cast<Eigen::Index>(block) * n_; }
  void factorise();

  int n_;       // block size
  int blocks_;  // number of blocks in each direction
  /// Element c holds the blocks below the diagonal block c, one above the other: A_ic D_c^-1.
  std::vector<Eigen::MatrixXd> lower_;
  /// Element c holds the blocks to the right of the diagonal block c, side by side.
  std::vector<Eigen::MatrixXd> upper_;
  std::vector<Eigen::MatrixXd> diagonal_;  // diagonal blocks D_c, later their inverses
};

}  // namespace fpkcheck::numerics
