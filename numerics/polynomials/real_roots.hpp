#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::numerics {

/// The real roots of odd multiplicity in (low, high), increasing: the points where the polynomial
/// changes its sign. Found between the roots of the derivative, where the polynomial is monotone.
std::vector<double> sign_changes(const Polynomial& polynomial, double low, double high);

/// Cauchy's bound of the roots, 1 + max |a_n / a_degree|: every root has a smaller modulus. 0 for a
/// constant.
double root_bound(const Polynomial& polynomial);

}  // namespace fpkcheck::numerics
