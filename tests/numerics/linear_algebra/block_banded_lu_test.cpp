#include "numerics/linear_algebra/block_banded_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace fpkcheck::numerics {
namespace {

// A matrix of 7 x 7 blocks of size 5 with unequal reaches to the left and to the right, and
// dominant diagonal elements.
Eigen::SparseMatrix<double> banded_matrix() {
  constexpr int kBlocks = 7, kSize = 5;
  std::vector<Eigen::Triplet<double>> entries;
  for (int r = 0; r < kBlocks; ++r) {
    for (int c = 0; c < kBlocks; ++c) {
      const bool is_nonzero =
          (c <= r + 1 && c >= r - 2) || (r == 0 && c == 3) || (r == 5 && c == 2);
      if (!is_nonzero) continue;
      for (int i = 0; i < kSize; ++i) {
        for (int j = 0; j < kSize; ++j) {
          const double value = std::sin(1 + 3.7 * (r * kSize + i) + 1.3 * (c * kSize + j));
          entries.emplace_back(r * kSize + i, c * kSize + j,
                               value + (r == c && i == j ? 25.0 : 0.0));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(kBlocks * kSize, kBlocks * kSize);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(BlockBandedLu, SolvesTheSystemsOfTheMatrixAndOfItsTranspose) {
  const Eigen::SparseMatrix<double> matrix = banded_matrix();
  const Eigen::MatrixXd dense(matrix);
  const BlockBandedLu lu(matrix, 5);
  ASSERT_TRUE(lu.is_finite());
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(dense.rows(), -1, 2);
  Eigen::VectorXd x = right, transposed = right;
  lu.solve_in_place(x);
  lu.solve_transposed_in_place(transposed);
  EXPECT_LT((x - dense.partialPivLu().solve(right)).norm(), 1e-13 * right.norm());
  const Eigen::MatrixXd of_transpose = dense.transpose();
  EXPECT_LT((transposed - of_transpose.partialPivLu().solve(right)).norm(), 1e-13 * right.norm());
}

TEST(BlockBandedLu, IsNotFiniteForASingularBlock) {
  Eigen::SparseMatrix<double> matrix = banded_matrix();
  matrix *= 0;
  EXPECT_FALSE(BlockBandedLu(matrix, 5).is_finite());
}

}  // namespace
}  // namespace fpkcheck::numerics
