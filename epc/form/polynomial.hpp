#pragma once

#include <cstddef>
#include <vector>

namespace fpkcheck::epc {

/// One term a x1^p x2^q of Q_n.
struct Term {
  int x1;    ///< power p of x1
  int x2;    ///< power q of x2
  double a;  ///< coefficient a
};

/// The polynomial Q_n(x1, x2; a) of paper (18), without a constant term.
class Polynomial {
 public:
  explicit Polynomial(std::vector<Term> terms);

  const std::vector<Term>& terms() const { return terms_; }
  int degree() const { return degree_; }

  double operator()(double x1, double x2) const;

  /// Coefficients of the polynomial rho -> Q_n(rho e1, rho e2). Entry m multiplies rho^m,
  /// m = 0 .. degree.
  std::vector<double> restriction_to_ray(double e1, double e2) const;

 private:
  std::vector<Term> terms_;
  int degree_;
  std::vector<double> triangle_;  // rows p = degree .. 0, each with q = degree - p .. 0
};

/// Value at rho of the polynomial with the given coefficients, lowest power first, by Horner's
/// method.
inline double horner(const std::vector<double>& coefficients, double rho) {
  double value = 0;
  for (std::size_t m = coefficients.size(); m-- > 0;) value = value * rho + coefficients[m];
  return value;
}

/// Coefficients of the derivative of a polynomial in one variable, lowest power first.
std::vector<double> derivative_coefficients(const std::vector<double>& coefficients);

}  // namespace fpkcheck::epc
