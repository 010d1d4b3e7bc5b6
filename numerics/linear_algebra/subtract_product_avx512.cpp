#include "numerics/linear_algebra/subtract_product_kernel.hpp"

namespace fpkcheck::numerics::avx512 {

void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner) {
  subtract_product_blocked<8, 3, 8>(c, leading_dimension, a, b, rows, columns, inner);
}

}  // namespace fpkcheck::numerics::avx512
