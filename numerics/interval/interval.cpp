#include "numerics/interval/interval.hpp"

#include <cassert>
#include <stdexcept>

namespace fpkcheck::numerics {
namespace {

// Tests whether the sums 1 + 2^-60 and -1 - 2^-60 are rounded upward.
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
  assert(x.upper() <= 0);
  int squarings = 0;
  double scale = 1;  // power of two, by which scaling is exact
  while (magnitude(x) * scale > 0.25) {
    scale /= 2;
    ++squarings;
  }
  const Interval z = x * scale;
  // The remainder of the Taylor polynomial of e^z, sum_{n <= 14} z^n / n!, is at most |z|^15
  // e^{|z|} / 15!
  // <= 2 * 4^-15 / 15! < 2e-21.
  Interval sum = 1;
  for (int n = 14; n > 0; --n) sum = 1.0 + z * sum / static_cast<double>(n);
  sum += symmetric_interval(2e-21);
  for (int i = 0; i < squarings; ++i) sum *= sum;
  return sum;
}

double binomial_coefficient(int n, int j) {
  double c = 1;
  // The variable c is a binomial coefficient, and thus an integer, after each step of the loop.
  for (int i = 1; i <= j; ++i) c = c * (n - j + i) / i;
  return c;
}

BernsteinCoefficients elevate_bernstein_degree(std::span<const Interval> b, int degree) {
  // Degree elevation: the Bernstein coefficient i of degree n+1 is (i b_{i-1} + (n+1-i) b_i) /
  // (n+1).
  BernsteinCoefficients e(b.begin(), b.end());
  for (int n = static_cast<int>(b.size()) - 1; n < degree; ++n) {
    BernsteinCoefficients next(n + 2);
    for (int i = 0; i <= n + 1; ++i) {
      Interval sum = 0;
      if (i > 0) sum += static_cast<double>(i) * e[i - 1];
      if (i <= n) sum += static_cast<double>(n + 1 - i) * e[i];
      next[i] = sum / static_cast<double>(n + 1);
    }
    e = std::move(next);
  }
  return e;
}

BernsteinCoefficients bernstein_product(std::span<const Interval> a, std::span<const Interval> b) {
  const int m = static_cast<int>(a.size()) - 1, n = static_cast<int>(b.size()) - 1;
  BernsteinCoefficients p(m + n + 1, Interval(0));
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j)
      p[i + j] += binomial_coefficient(m, i) * a[i] * (binomial_coefficient(n, j) * b[j]);
  }
  for (int k = 0; k <= m + n; ++k) p[k] /= binomial_coefficient(m + n, k);
  return p;
}

BernsteinCoefficients bernstein_derivative(std::span<const Interval> b) {
  const int n = static_cast<int>(b.size()) - 1;
  BernsteinCoefficients d(std::max(n, 1), Interval(0));
  for (int j = 0; j < n; ++j) d[j] = static_cast<double>(n) * (b[j + 1] - b[j]);
  return d;
}

Interval evaluate_bernstein_polynomial(std::span<const Interval> b, const Interval& t) {
  BernsteinCoefficients c(b.begin(), b.end());
  const Interval s = 1.0 - t;
  for (std::size_t n = c.size(); n-- > 1;) {
    for (std::size_t j = 0; j < n; ++j) c[j] = s * c[j] + t * c[j + 1];
  }
  return c[0];
}

BernsteinCoefficients bernstein_from_power_coefficients(std::span<const Interval> a) {
  // A power has the Bernstein form t^k = sum_j C(j, k)/C(n, k) B_j(t) with Bernstein polynomials
  // B_j.
  const int n = static_cast<int>(a.size()) - 1;
  BernsteinCoefficients b(n + 1, Interval(0));
  for (int j = 0; j <= n; ++j) {
    for (int k = 0; k <= j; ++k)
      b[j] += a[k] * binomial_coefficient(j, k) / binomial_coefficient(n, k);
  }
  return b;
}

BernsteinCoefficients power_coefficients_from_bernstein(std::span<const Interval> b) {
  // The power coefficient a_k is C(n, k) times the k-th forward difference of the Bernstein
  // coefficients b at index 0.
  const int n = static_cast<int>(b.size()) - 1;
  BernsteinCoefficients difference(b.begin(), b.end()), a(n + 1);
  for (int k = 0; k <= n; ++k) {
    a[k] = binomial_coefficient(n, k) * difference[0];
    for (int j = 0; j < n - k; ++j) difference[j] = difference[j + 1] - difference[j];
  }
  return a;
}

BernsteinCoefficients bernstein_coefficients_on_segment(std::span<const double> a,
                                                        const Interval& origin,
                                                        const Interval& from, const Interval& to) {
  // Horner's rule in Bernstein form, where x - origin is a polynomial of degree 1 in t.
  const BernsteinCoefficients x{from - origin, to - origin};
  BernsteinCoefficients b{Interval(a.back())};
  for (std::size_t k = a.size() - 1; k-- > 0;) {
    b = bernstein_product(b, x);
    for (Interval& c : b) c += a[k];
  }
  return b;
}

}  // namespace fpkcheck::numerics
