#pragma once

#include <memory>

#include "numerics/linear_algebra/subtract_product.hpp"

// Implementation of subtract_product(), which one source file for each instruction set includes.
// Each source file chooses the block sizes kVectors, kWidth and kColumns by the registers of its
// instruction set. All functions of this header have internal linkage.

namespace fpkcheck::numerics {
namespace {

template <int kWidth>
struct SimdVectorType {
  typedef double Type __attribute__((vector_size(8 * kWidth)));
};

/// Computes C - A B by blocks: each block of the matrix C with kVectors * kWidth rows and kColumns
/// columns is computed in registers. The required parts of the matrices A and B are first copied in
/// the order of access and padded with zeros.
template <int kWidth, int kVectors, int kColumns>
void subtract_product_blocked(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                              const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                              std::ptrdiff_t inner) {
  using Vector = typename SimdVectorType<kWidth>::Type;
  constexpr std::ptrdiff_t kRows = kVectors * kWidth;
  const std::ptrdiff_t blocks = (columns + kColumns - 1) / kColumns;
  const auto count = [](std::ptrdiff_t n) { return static_cast<std::size_t>(n); };
  const std::unique_ptr<double[]> a_copy(new double[count(kRows * inner)]);
  const std::unique_ptr<double[]> b_copy(new double[count(blocks * kColumns * inner)]);
  for (std::ptrdiff_t block = 0; block < blocks; ++block) {
    double* to = b_copy.get() + block * kColumns * inner;
    for (std::ptrdiff_t k = 0; k < inner; ++k) {
      for (std::ptrdiff_t j = block * kColumns; j < (block + 1) * kColumns; ++j) {
        *to++ = j < columns ? b.first[k * b.row_stride + j * b.column_stride] : 0.0;
      }
    }
  }
  for (std::ptrdiff_t row = 0; row < rows; row += kRows) {
    const std::ptrdiff_t height = rows - row < kRows ? rows - row : kRows;
    double* to = a_copy.get();
    for (std::ptrdiff_t k = 0; k < inner; ++k) {
      const double* from = a.first + row * a.row_stride + k * a.column_stride;
      for (std::ptrdiff_t i = 0; i < kRows; ++i) *to++ = i < height ? from[i * a.row_stride] : 0.0;
    }
    for (std::ptrdiff_t block = 0; block < blocks; ++block) {
      Vector sum[kColumns][kVectors]{};
      const double* x = a_copy.get();
      const double* y = b_copy.get() + block * kColumns * inner;
      for (std::ptrdiff_t k = 0; k < inner; ++k, x += kRows, y += kColumns) {
        Vector column[kVectors];
        __builtin_memcpy(column, x, sizeof column);
#pragma GCC unroll 16
        for (int j = 0; j < kColumns; ++j) {
#pragma GCC unroll 4
          for (int i = 0; i < kVectors; ++i) sum[j][i] += column[i] * y[j];
        }
      }
      for (int j = 0; j < kColumns && block * kColumns + j < columns; ++j) {
        double* const at = c + row + (block * kColumns + j) * leading_dimension;
        double values[kRows];
        __builtin_memcpy(values, sum[j], sizeof values);
        for (std::ptrdiff_t i = 0; i < height; ++i) at[i] -= values[i];
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::numerics
