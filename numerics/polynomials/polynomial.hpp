#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace fpkcheck::numerics {

/// Polynomial sum_n a_n y^n of the variable y, n = 0 .. kDegree.
class Polynomial {
 public:
  static constexpr std::size_t kDegree = 6;
  using Coefficients = std::array<double, kDegree + 1>;

  constexpr explicit Polynomial(const Coefficients& a) : a_(a) {}

  /// Evaluates the polynomial at y, a number or an array of numbers, by Horner's rule.
  template <class Real>
  constexpr Real operator()(const Real& y) const {
    Real value = a_[kDegree] + 0.0 * y;
    for (std::size_t n = kDegree; n-- > 0;) value = value * y + a_[n];
    return value;
  }

  constexpr double coefficient(std::size_t n) const { return a_[n]; }
  constexpr const Coefficients& coefficients() const { return a_; }
  /// Returns the degree, the largest n with a_n != 0; the degree of a constant polynomial is 0.
  constexpr std::size_t degree() const {
    std::size_t n = kDegree;
    while (n > 0 && a_[n] == 0) --n;
    return n;
  }

  constexpr Polynomial derivative() const {
    Coefficients d{};
    for (std::size_t n = 1; n <= kDegree; ++n) d[n - 1] = static_cast<double>(n) * a_[n];
    return Polynomial(d);
  }
  /// Returns the polynomial of x that results from the substitution y = origin + sign x.
  constexpr Polynomial compose_affine(double origin, double sign) const {
    Coefficients q{};
    for (std::size_t n = kDegree + 1; n-- > 0;) {
      for (std::size_t m = kDegree; m > 0; --m) q[m] = origin * q[m] + sign * q[m - 1];
      q[0] = origin * q[0] + a_[n];
    }
    return Polynomial(q);
  }
  constexpr Polynomial multiplied_by(double factor) const {
    Coefficients p{};
    for (std::size_t n = 0; n <= kDegree; ++n) p[n] = factor * a_[n];
    return Polynomial(p);
  }
  /// Returns the product of y and this polynomial.
  /// @pre degree() < kDegree
  constexpr Polynomial multiplied_by_argument() const {
    assert(degree() < kDegree);
    Coefficients p{};
    for (std::size_t n = 0; n < kDegree; ++n) p[n + 1] = a_[n];
    return Polynomial(p);
  }
  /// Returns the antiderivative of the polynomial that is 0 at y = 0.
  /// @pre degree() < kDegree
  constexpr Polynomial antiderivative() const {
    assert(degree() < kDegree);
    Coefficients i{};
    for (std::size_t n = 0; n < kDegree; ++n) i[n + 1] = a_[n] / static_cast<double>(n + 1);
    return Polynomial(i);
  }

 private:
  Coefficients a_;
};

/// Returns the real roots of odd multiplicity of a polynomial in (low, high), in increasing order.
/// Each root is searched between two neighbouring sign changes of the derivative, where the
/// polynomial is monotone.
std::vector<double> sign_change_points(const Polynomial& polynomial, double low, double high);

/// Returns Cauchy's bound 1 + max |a_n / a_degree| of the modulus of all roots of a polynomial with
/// the coefficients a_n; 0 for a constant polynomial.
double root_modulus_bound(const Polynomial& polynomial);

}  // namespace fpkcheck::numerics
