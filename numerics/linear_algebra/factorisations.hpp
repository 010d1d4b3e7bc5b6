#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

/// LU factorisation, singular values and eigenvalues of dense matrices, and Cholesky factorisation
/// of block-banded matrices.
namespace fpkcheck::numerics {

/// LU factors of a square matrix with partial pivoting. Only factorisations.cpp includes Eigen's
/// decomposition, so that Eigen's templates are compiled once.
class LuFactors {
 public:
  explicit LuFactors(const Eigen::MatrixXd& matrix);
  LuFactors(LuFactors&&) noexcept;
  LuFactors& operator=(LuFactors&&) noexcept;
  ~LuFactors();

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
  double determinant() const;

 private:
  std::unique_ptr<Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

/// Returns the singular values of a matrix in decreasing order.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// Returns the eigenvalue with the largest real part of a square matrix. Of a complex conjugate
/// pair the function returns the eigenvalue with the positive imaginary part.
std::complex<double> rightmost_eigenvalue(const Eigen::MatrixXd& matrix);

struct MatrixSingularityIndicators {
  double smallest_singular_value;
  int determinant_sign;  ///< sign of the determinant: -1, 0 or 1
};
MatrixSingularityIndicators singularity_indicators(const Eigen::MatrixXd& matrix);

/// A symmetric positive definite matrix of dense blocks, which factorise() replaces by its Cholesky
/// factor. The blocks of the matrix may have different sizes. Blocks (row, column) with |row -
/// column| > bandwidth are zero.
class BlockBandedMatrix {
 public:
  BlockBandedMatrix(std::vector<Eigen::Index> block_sizes, int bandwidth);

  Eigen::Index size() const { return offsets_.back(); }
  int block_count() const { return static_cast<int>(offsets_.size()) - 1; }
  /// Returns the block (row, column) of the lower triangle, column <= row <= column + bandwidth.
  Eigen::Ref<Eigen::MatrixXd> block(int row, int column);

  Eigen::VectorXd diagonal() const;
  /// Replaces the matrix A by S A S with the diagonal matrix S = diag(scale).
  void scale_symmetrically(const Eigen::VectorXd& scale);
  void add_to_diagonal(double value);

  /// Replaces the matrix A by its Cholesky factor L, A = L L^T.
  /// @return false if the matrix A is not numerically positive definite
  bool factorise();
  /// Replaces the matrix b by A^-1 b, where A is the factorised matrix.
  /// @param b shape (size, any number of columns)
  /// @pre factorise() has returned true
  void solve_in_place(Eigen::MatrixXd& b) const;

 private:
  int last_block_row(int column) const { return std::min(column + bandwidth_, block_count() - 1); }

  std::vector<Eigen::Index> offsets_;
  int bandwidth_;
  bool is_factorised_ = false;
  // columns_[column] contains the stacked blocks of the block rows `column` ..
  // last_block_row(column).
  std::vector<Eigen::MatrixXd> columns_;
};

}  // namespace fpkcheck::numerics
