#pragma once

#include <cstddef>

namespace fpkcheck::numerics {

/// A matrix in memory, given by the address of its first element and two strides.
struct StridedMatrix {
  const double* first;
  /// Distances in memory from a matrix element to the element in the next row, and to the element
  /// in the next column.
  std::ptrdiff_t row_stride, column_stride;
};

/// Replaces the matrix C, stored by columns, by C - A B. The shapes of C, A and B are (rows,
/// columns), (rows, inner) and (inner, columns). The results are bit-identical for all instruction
/// sets: each element of the product A B is summed in the order of the inner index, and
/// -ffp-contract=off prevents fused multiply-add.
void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner);

// The implementations of subtract_product(), one for each instruction set.
using SubtractProductKernel = void(double* c, std::ptrdiff_t leading_dimension,
                                   const StridedMatrix& a, const StridedMatrix& b,
                                   std::ptrdiff_t rows, std::ptrdiff_t columns,
                                   std::ptrdiff_t inner);
namespace baseline {
SubtractProductKernel subtract_product;
}
namespace avx2 {
SubtractProductKernel subtract_product;
}
namespace avx512 {
SubtractProductKernel subtract_product;
}

}  // namespace fpkcheck::numerics
