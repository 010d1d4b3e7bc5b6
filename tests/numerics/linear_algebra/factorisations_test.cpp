#include "numerics/linear_algebra/factorisations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fpkcheck::numerics {
namespace {

// A block-banded matrix with blocks of sizes 2, 4, 4, 3, 4, 4, and its dense form.
struct Example {
  BlockBandedMatrix banded{{2, 4, 4, 3, 4, 4}, 2};
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(21, 21);

  explicit Example(double diagonal) {
    const std::array<Eigen::Index, 6> offsets{0, 2, 6, 10, 13, 17};  // first rows of the blocks
    for (int c = 0; c < banded.block_count(); ++c) {
      for (int r = c; r <= std::min(c + 2, banded.block_count() - 1); ++r) {
        auto block = banded.block(r, c);
        for (int i = 0; i < block.rows(); ++i) {
          for (int j = 0; j < block.cols(); ++j) {
            const Eigen::Index row = offsets[r] + i, column = offsets[c] + j;
            const double product = static_cast<double>(row * column);
            const double value =
                row == column ? diagonal + std::sqrt(product) : std::cos(product + 1);
            block(i, j) = value;
            dense(row, column) = dense(column, row) = value;
          }
        }
      }
    }
  }
};

TEST(BlockBandedMatrix, SolvesLikeADenseFactor) {
  Example example(12);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(21, 3);
  Eigen::MatrixXd x = b;
  ASSERT_TRUE(example.banded.factorise());
  example.banded.solve_in_place(x);
  EXPECT_LT((example.dense * x - b).norm(), 1e-12 * b.norm());
}

TEST(BlockBandedMatrix, IsScaledAndShiftedAsAMatrix) {
  Example example(12);
  const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(21, 0.5, 2);
  example.banded.scale_symmetrically(scale);
  example.banded.add_to_diagonal(0.3);
  Eigen::MatrixXd dense = scale.asDiagonal() * example.dense * scale.asDiagonal();
  dense.diagonal().array() += 0.3;
  EXPECT_LT((example.banded.diagonal() - dense.diagonal()).norm(), 1e-13);
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(21, 1);
  ASSERT_TRUE(example.banded.factorise());
  example.banded.solve_in_place(x);
  EXPECT_LT((dense * x - Eigen::MatrixXd::Ones(21, 1)).norm(), 1e-12);
}

TEST(BlockBandedMatrix, ReportsIndefiniteMatrix) {
  Example example(-1);
  EXPECT_FALSE(example.banded.factorise());
}

TEST(RightmostEigenvalue, HasTheLargestRealPartAndAPositiveImaginaryPart) {
  // Eigenvalues -1 +- 2 i and -3
  const Eigen::Matrix3d oscillating{{-1, 2, 0}, {-2, -1, 0}, {5, 0, -3}};
  EXPECT_NEAR(rightmost_eigenvalue(oscillating).real(), -1, 1e-12);
  EXPECT_NEAR(rightmost_eigenvalue(oscillating).imag(), 2, 1e-12);
  const Eigen::Matrix2d triangular{{-4, 7}, {0, 0.5}};
  EXPECT_NEAR(rightmost_eigenvalue(triangular).real(), 0.5, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::numerics
