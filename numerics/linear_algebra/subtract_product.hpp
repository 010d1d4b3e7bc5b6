#pragma once

#include <cstddef>

namespace fpkcheck::numerics {

/// A matrix given by its first element and two strides.
struct StridedMatrix {
  const double* first;
  std::ptrdiff_t row_stride,
      column_stride;  ///< distances between neighbours in a column and in a row
};

/// C -= A B with shapes (rows, columns), (rows, inner) and (inner, columns). C is stored by columns
/// with the leading dimension `leading_dimension`. Compiled for several instruction sets, all with
/// bit-identical results: each element is one sum in the order of the inner index, and
/// -ffp-contract=off prevents fused operations.
void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner);

// The implementations for each instruction set.
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
