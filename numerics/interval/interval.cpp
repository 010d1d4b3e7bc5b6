#include "numerics/interval/interval.hpp"

#include <stdexcept>

namespace fpkcheck::numerics {
namespace {

// Whether upward rounding is in effect, tested with the sums 1 + 2^-60 and -1 - 2^-60.
bool is_rounding_upward() {
  volatile double one = 1, tiny = 0x1p-60;
  volatile double above = one + tiny, below = -one - tiny;
  return above > 1 && below == -1;
}

}  // namespace

UpwardRounding::UpwardRounding() : before_(std::fegetround()) {
  std::fesetround(FE_UPWARD);
  if (!is_rounding_upward()) {
    std::fesetround(before_);
    throw std::runtime_error(
        "guaranteed bounds: upward rounding is not in effect; build with -frounding-math");
  }
}

UpwardRounding::~UpwardRounding() { std::fesetround(before_); }

Interval power(const Interval& x, int n) {
  Interval result = 1;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

Interval exponential(const Interval& x) {
  int squarings = 0;
  double scale = 1;  // a power of two, so that scaling is exact
  while (magnitude(x) * scale > 0.25) {
    scale /= 2;
    ++squarings;
  }
  const Interval z = x * scale;
  // sum_{n <= 14} z^n / n!, remainder |z|^15 e^{|z|} / 15! <= 2 * 4^-15 / 15! < 2e-21
  Interval sum = 1;
  for (int n = 14; n > 0; --n) sum = 1.0 + z * sum / static_cast<double>(n);
  sum += symmetric_interval(2e-21);
  for (int i = 0; i < squarings; ++i) sum *= sum;
  return sum;
}

}  // namespace fpkcheck::numerics
