#include "numerics/linear_algebra/subtract_product_kernel.hpp"

namespace fpkcheck::numerics::baseline {

void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner) {
  subtract_product_blocked<2, 2, 4>(c, leading_dimension, a, b, rows, columns, inner);
}

}  // namespace fpkcheck::numerics::baseline
