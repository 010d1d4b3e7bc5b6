#include "numerics/linear_algebra/subtract_product_kernel.hpp"

namespace fpkcheck::numerics::avx512 {

void subtract_product(double* c, std::ptrdiff_t pitch, const Strided& a, const Strided& b,
                      std::ptrdiff_t rows, std::ptrdiff_t columns, std::ptrdiff_t inner) {
  multiply<8, 3, 8>(c, pitch, a, b, rows, columns, inner);
}

}  // namespace fpkcheck::numerics::avx512
