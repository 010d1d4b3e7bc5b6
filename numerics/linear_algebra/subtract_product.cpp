#include "numerics/linear_algebra/subtract_product_kernel.hpp"

namespace fpkcheck::numerics {

void baseline::subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                                const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                                std::ptrdiff_t inner) {
  subtract_product_blocked<2, 2, 4>(c, leading_dimension, a, b, rows, columns, inner);
}

namespace {

SubtractProductKernel* fastest_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return avx512::subtract_product;
  if (__builtin_cpu_supports("avx2")) return avx2::subtract_product;
#endif
  return baseline::subtract_product;
}

}  // namespace

void subtract_product(double* c, std::ptrdiff_t leading_dimension, const StridedMatrix& a,
                      const StridedMatrix& b, std::ptrdiff_t rows, std::ptrdiff_t columns,
                      std::ptrdiff_t inner) {
  static SubtractProductKernel* const chosen = fastest_kernel();
  chosen(c, leading_dimension, a, b, rows, columns, inner);
}

}  // namespace fpkcheck::numerics
