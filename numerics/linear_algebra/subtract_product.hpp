#pragma once

#include <cstddef>

namespace fpkcheck::numerics {

/// A matrix in memory, given by the address of its first element and two strides.
struct StridedMatrix {
  const double* first;
  /// Distances in memory of neighbours in a column, and of neighbours in a row.
  std::ptrdiff_t row_stride, column_stride;
};

/// Replaces the matrix C by C - A B. The shapes of C, A and B are (rows, columns), (rows, inner)
/// and (inner, columns). C is stored by columns with the leading dimension `leading_dimension`. The
/// function is compiled for several instruction sets with bit-identical results: each element of A
/// B is one sum in the order of the inner index, and -ffp-contract=off prevents fused multiply-add.
void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner);

// The implementations of subtract_product(), one for each instruction set.
using SubtractProduct = void(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                             const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                             std::ptrdiff_t inner);
namespace baseline {
SubtractProduct subtract_product;
}
namespace avx2 {
SubtractProduct subtract_product;
}
namespace avx512 {
SubtractProduct subtract_product;
}

}  // namespace fpkcheck::numerics
