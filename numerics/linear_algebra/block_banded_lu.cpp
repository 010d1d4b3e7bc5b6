#include "numerics/linear_algebra/block_banded_lu.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

#include "numerics/linear_algebra/subtract_product.hpp"

namespace fpkcheck::numerics {
namespace {

// Replaces the matrix C by C - A B for blocks of matrices that are stored by columns.
void subtract_block_product(Eigen::Ref<Eigen::MatrixXd> c,
                            const Eigen::Ref<const Eigen::MatrixXd>& a,
                            const Eigen::Ref<const Eigen::MatrixXd>& b) {
  subtract_product(c.data(), c.outerStride(), {a.data(), 1, a.outerStride()},
                   {b.data(), 1, b.outerStride()}, c.rows(), c.cols(), a.cols());
}

}  // namespace

BlockBandedLu::BlockBandedLu(const Eigen::SparseMatrix<double>& matrix, int block_size)
    : n_(block_size), blocks_(static_cast<int>(matrix.rows() / block_size)) {
  assert(matrix.rows() == matrix.cols() && matrix.rows() % block_size == 0);
  // Index of the last nonzero block in each block column and in each block row, increased to a
  // nondecreasing sequence
  std::vector<int> last_row(static_cast<std::size_t>(blocks_)), last_column(last_row);
  for (int c = 0; c < blocks_; ++c) last_row[c] = last_column[c] = c;
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (Entry e(matrix, column); e; ++e) {
      const auto r = static_cast<std::size_t>(e.row() / n_),
                 c = static_cast<std::size_t>(column / n_);
      last_row[c] = std::max(last_row[c], static_cast<int>(r));
      last_column[r] = std::max(last_column[r], static_cast<int>(c));
    }
  }
  for (int c = 1; c < blocks_; ++c) {
    last_row[c] = std::max(last_row[c], last_row[c - 1]);
    last_column[c] = std::max(last_column[c], last_column[c - 1]);
  }
  for (int c = 0; c < blocks_; ++c) {
    diagonal_.push_back(Eigen::MatrixXd::Zero(n_, n_));
    lower_.push_back(Eigen::MatrixXd::Zero((last_row[c] - c) * n_, n_));
    upper_.push_back(Eigen::MatrixXd::Zero(n_, (last_column[c] - c) * n_));
  }
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (Entry e(matrix, column); e; ++e) {
      const int r = static_cast<int>(e.row() / n_), c = static_cast<int>(column / n_);
      const Eigen::Index i = e.row() % n_, j = column % n_;
      if (r == c) {
        diagonal_[c](i, j) = e.value();
      } else if (r > c) {
        lower_[c]((r - c - 1) * n_ + i, j) = e.value();
      } else {
        upper_[r](i, (c - r - 1) * n_ + j) = e.value();
      }
    }
  }
  factorise();
}

void BlockBandedLu::factorise() {
  for (int c = 0; c < blocks_; ++c) {
    diagonal_[c] = Eigen::MatrixXd(diagonal_[c].partialPivLu().inverse());
    const Eigen::MatrixXd below = -lower_[c];
    lower_[c].setZero();
    if (below.rows() == 0) continue;
    subtract_block_product(lower_[c], below, diagonal_[c]);
    const auto rows = static_cast<int>(lower_[c].rows() / n_);
    const auto columns = static_cast<int>(upper_[c].cols() / n_);
    for (int j = 1; j <= columns; ++j) {
      const auto right = upper_[c].middleCols((j - 1) * n_, n_);
      // The loop over i updates the blocks above the diagonal block c + j. The statements after the
      // loop over i update the diagonal block and the blocks below the diagonal.
      for (int i = 1; i < std::min(j, rows + 1); ++i) {
        subtract_block_product(upper_[c + i].middleCols((j - i - 1) * n_, n_),
                               lower_[c].middleRows((i - 1) * n_, n_), right);
      }
      if (j <= rows) {
        subtract_block_product(diagonal_[c + j], lower_[c].middleRows((j - 1) * n_, n_), right);
      }
      if (j < rows) {
        subtract_block_product(lower_[c + j].topRows((rows - j) * n_),
                               lower_[c].bottomRows((rows - j) * n_), right);
      }
    }
  }
}

void BlockBandedLu::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  for (int c = 0; c < blocks_; ++c) {
    b.segment(first_row_of_block(c + 1), lower_[c].rows()).noalias() -=
        lower_[c] * b.segment(first_row_of_block(c), n_);
  }
  for (int c = blocks_; c-- > 0;) {
    auto x = b.segment(first_row_of_block(c), n_);
    x.noalias() -= upper_[c] * b.segment(first_row_of_block(c + 1), upper_[c].cols());
    x = diagonal_[c] * Eigen::VectorXd(x);
  }
}

void BlockBandedLu::solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  for (int c = 0; c < blocks_; ++c) {
    auto x = b.segment(first_row_of_block(c), n_);
    x = diagonal_[c].transpose() * Eigen::VectorXd(x);
    b.segment(first_row_of_block(c + 1), upper_[c].cols()).noalias() -= upper_[c].transpose() * x;
  }
  for (int c = blocks_; c-- > 0;) {
    b.segment(first_row_of_block(c), n_).noalias() -=
        lower_[c].transpose() * b.segment(first_row_of_block(c + 1), lower_[c].rows());
  }
}

bool BlockBandedLu::is_finite() const {
  return std::ranges::all_of(diagonal_, [](const auto& block) { return block.allFinite(); });
}

}  // namespace fpkcheck::numerics
