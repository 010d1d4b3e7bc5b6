#pragma once

#include <cmath>
#include <vector>

#include "epc/form/exponent_polynomial.hpp"

/// Polynomial exponents for tests, in a plane with a different standard deviation for each axis.
namespace fpkcheck::tests {

inline const epc::StandardDeviations kSigma{0.5, 2.0};

/// Returns the polynomial whose terms are given in u = x1/sigma_1 and w = x2/sigma_2.
inline epc::ExponentPolynomial scaled_polynomial(std::vector<epc::ExponentMonomial> terms) {
  for (auto& [p, q, a] : terms) a /= std::pow(kSigma.x1, p) * std::pow(kSigma.x2, q);
  return epc::ExponentPolynomial(terms);
}

/// Returns the exponent -rho^2/2 + quartic rho^4 of the scaled radius rho.
inline epc::ExponentPolynomial radial_quartic_polynomial(double quartic) {
  return scaled_polynomial(
      {{2, 0, -0.5}, {0, 2, -0.5}, {4, 0, quartic}, {2, 2, 2 * quartic}, {0, 4, quartic}});
}

}  // namespace fpkcheck::tests
