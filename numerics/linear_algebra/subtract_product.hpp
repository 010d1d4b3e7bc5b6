#pragma once

#include <cstddef>

namespace fpkcheck::numerics {

/// A matrix by its first element and the distances between neighbours in a column and in a row.
struct Strided {
  const double* first;
  std::ptrdiff_t down, along;
};

/// C -= A B, C by columns that lie `pitch` apart, shapes (rows, columns), (rows, inner) and (inner,
/// columns). Compiled for several instruction sets; all give the same bits, since each element is
/// one sum in the order of the inner index and nothing is contracted.
void subtract_product(double* c, std::ptrdiff_t pitch, const Strided& a, const Strided& b,
                      std::ptrdiff_t rows, std::ptrdiff_t columns, std::ptrdiff_t inner);

// The same, for different instructions.
using SubtractProduct = void(double* c, std::ptrdiff_t pitch, const Strided& a, const Strided& b,
                             std::ptrdiff_t rows, std::ptrdiff_t columns, std::ptrdiff_t inner);
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
