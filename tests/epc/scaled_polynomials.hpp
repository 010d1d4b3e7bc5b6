#pragma once

#include <cmath>
#include <vector>

#include "epc/form/polynomial.hpp"

/// Polynomial exponents for tests, in a plane with a different standard deviation for each axis.
namespace fpkcheck::tests {

inline const epc::StandardDeviations kSigma{0.5, 2.0};

/// Polynomial of u = x1/sigma_1 and w = x2/sigma_2.
inline epc::Polynomial scaled(std::vector<epc::Term> terms) {
  for (auto& [p, q, a] : terms) a /= std::pow(kSigma.x1, p) * std::pow(kSigma.x2, q);
  return epc::Polynomial(terms);
}

/// The exponent -rho^2/2 + quartic rho^4.
inline epc::Polynomial radial(double quartic) {
  return scaled(
      {{2, 0, -0.5}, {0, 2, -0.5}, {4, 0, quartic}, {2, 2, 2 * quartic}, {0, 4, quartic}});
}

}  // namespace fpkcheck::tests
