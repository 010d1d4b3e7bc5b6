#include "numerics/linear_algebra/factorisations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <utility>

#include "numerics/linear_algebra/subtract_product.hpp"

namespace fpkcheck::numerics {

LuFactors::LuFactors(const Eigen::MatrixXd& matrix)
    : lu_(std::make_unique<Eigen::PartialPivLU<Eigen::MatrixXd>>(matrix)) {}
LuFactors::LuFactors(LuFactors&&) noexcept = default;
LuFactors& LuFactors::operator=(LuFactors&&) noexcept = default;
LuFactors::~LuFactors() = default;

Eigen::VectorXd LuFactors::solve(const Eigen::VectorXd& right_hand_side) const {
  return lu_->solve(right_hand_side);
}
double LuFactors::determinant() const { return lu_->determinant(); }

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return matrix.jacobiSvd().singularValues();
}

std::complex<double> rightmost_eigenvalue(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXcd values = matrix.eigenvalues();
  const auto is_left_of = [](std::complex<double> a, std::complex<double> b) {
    return std::pair(a.real(), a.imag()) < std::pair(b.real(), b.imag());
  };
  return *std::ranges::max_element(values, is_left_of);
}

MatrixSingularityIndicators singularity_indicators(const Eigen::MatrixXd& matrix) {
  const double determinant = LuFactors(matrix).determinant();
  return {.smallest_singular_value = singular_values(matrix).minCoeff(),
          .determinant_sign = determinant > 0   ? 1
                              : determinant < 0 ? -1
                                                : 0};
}

BlockBandedMatrix::BlockBandedMatrix(std::vector<Eigen::Index> block_sizes, int bandwidth)
    : offsets_{0}, bandwidth_(bandwidth) {
  for (const Eigen::Index size : block_sizes) offsets_.push_back(offsets_.back() + size);
  for (int c = 0; c < block_count(); ++c) {
    columns_.push_back(
        Eigen::MatrixXd::Zero(offsets_[last_block_row(c) + 1] - offsets_[c], block_sizes[c]));
  }
}

Eigen::Ref<Eigen::MatrixXd> BlockBandedMatrix::block(int row, int column) {
  return columns_[column].middleRows(offsets_[row] - offsets_[column],
                                     offsets_[row + 1] - offsets_[row]);
}

Eigen::VectorXd BlockBandedMatrix::diagonal() const {
  Eigen::VectorXd d(size());
  for (int c = 0; c < block_count(); ++c) {
    d.segment(offsets_[c], columns_[c].cols()) = columns_[c].diagonal();
  }
  return d;
}

void BlockBandedMatrix::scale_symmetrically(const Eigen::VectorXd& scale) {
  for (int c = 0; c < block_count(); ++c) {
    columns_[c] = scale.segment(offsets_[c], columns_[c].rows()).asDiagonal() * columns_[c] *
                  scale.segment(offsets_[c], columns_[c].cols()).asDiagonal();
  }
}

void BlockBandedMatrix::add_to_diagonal(double value) {
  for (Eigen::MatrixXd& column : columns_) column.diagonal().array() += value;
}

bool BlockBandedMatrix::factorise() {
  for (int c = 0; c < block_count(); ++c) {
    Eigen::MatrixXd& panel = columns_[c];
    const Eigen::Index n = panel.cols(), below = panel.rows() - n;
    const Eigen::LLT<Eigen::MatrixXd> llt(panel.topRows(n));
    if (llt.info() != Eigen::Success) return false;
    panel.topRows(n) = llt.matrixL();
    if (below == 0) continue;
    panel.topRows(n).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(
        panel.bottomRows(below));
    for (int j = c + 1; j <= last_block_row(c); ++j) {
      const Eigen::Index start = offsets_[j] - offsets_[c], rows = panel.rows() - start;
      Eigen::MatrixXd& target = columns_[j];
      subtract_product(target.data(), target.rows(), {&panel(start, 0), 1, panel.rows()},
                       {&panel(start, 0), panel.rows(), 1}, rows, target.cols(), n);
    }
  }
  is_factorised_ = true;
  return true;
}

void BlockBandedMatrix::solve_in_place(Eigen::MatrixXd& b) const {
  assert(is_factorised_);
  for (int c = 0; c < block_count(); ++c) {
    const Eigen::MatrixXd& panel = columns_[c];
    const Eigen::Index n = panel.cols(), below = panel.rows() - n;
    auto x = b.middleRows(offsets_[c], n);
    panel.topRows(n).triangularView<Eigen::Lower>().solveInPlace(x);
    if (below > 0) {
      subtract_product(&b(offsets_[c] + n, 0), b.rows(), {&panel(n, 0), 1, panel.rows()},
                       {x.data(), 1, b.rows()}, below, b.cols(), n);
    }
  }
  for (int c = block_count(); c-- > 0;) {
    const Eigen::MatrixXd& panel = columns_[c];
    const Eigen::Index n = panel.cols(), below = panel.rows() - n;
    auto x = b.middleRows(offsets_[c], n);
    if (below > 0) {
      subtract_product(x.data(), b.rows(), {&panel(n, 0), panel.rows(), 1},
                       {&b(offsets_[c] + n, 0), 1, b.rows()}, n, b.cols(), below);
    }
    panel.topRows(n).triangularView<Eigen::Lower>().transpose().solveInPlace(x);
  }
}

}  // namespace fpkcheck::numerics
