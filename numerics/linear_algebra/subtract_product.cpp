#include "numerics/linear_algebra/subtract_product.hpp"

namespace fpkcheck::numerics {
namespace {

SubtractProduct* fastest() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return avx512::subtract_product;
  if (__builtin_cpu_supports("avx2")) return avx2::subtract_product;
#endif
  return baseline::subtract_product;
}

}  // namespace

void subtract_product(double* c, std::ptrdiff_t pitch, const Strided& a, const Strided& b,
                      std::ptrdiff_t rows, std::ptrdiff_t columns, std::ptrdiff_t inner) {
  static SubtractProduct* const chosen = fastest();
  chosen(c, pitch, a, b, rows, columns, inner);
}

}  // namespace fpkcheck::numerics
