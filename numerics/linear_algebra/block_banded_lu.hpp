#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace fpkcheck::numerics {

/// LU factors of a sparse matrix whose dense blocks of equal size lie near the diagonal, without
/// exchanges of rows between blocks. The LU factors fill the envelope of the blocks: each block
/// column extends down to the last nonzero block in this and all earlier columns. Each block row
/// extends to the right to the last nonzero block in this and all earlier rows. A matrix s I - L
/// with a generator L and s > 0 requires no exchanges of rows.
class BlockBandedLu {
 public:
  /// @pre the number of rows of the matrix is a multiple of block_size
  BlockBandedLu(const Eigen::SparseMatrix<double>& matrix, int block_size);

  /// Replaces b by A^-1 b.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;
  /// Replaces b by A^-T b.
  void solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

  /// Returns whether all LU factors are finite, that is, whether every diagonal block was regular.
  bool is_finite() const;

  /// Returns the number of elements of the LU factors of a matrix with blocks up to
  /// `half_bandwidth` blocks from the diagonal. Callers compare the number of elements with the
  /// available memory and then choose between LU factors and GMRES.
  static double factor_element_count(double matrix_size, double block_size, int half_bandwidth) {
    return matrix_size * block_size * (1 + 2 * half_bandwidth);
  }

 private:
  Eigen::Index first_row_of_block(int block) const { return static_cast<Eigen::Index>(block) * n_; }
  void factorise();

  int n_;       // block size
  int blocks_;  // number of blocks in each direction
  /// lower_[c] contains the stacked blocks A_ic D_c^-1 below the diagonal block D_c of the matrix.
  std::vector<Eigen::MatrixXd> lower_;
  /// upper_[c] contains, side by side, the blocks to the right of the diagonal block c.
  std::vector<Eigen::MatrixXd> upper_;
  std::vector<Eigen::MatrixXd>
      diagonal_;  // diagonal blocks D_c; after factorise(), the inverses of D_c
};

}  // namespace fpkcheck::numerics
