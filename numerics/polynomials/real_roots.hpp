#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::numerics {

/// The points in (low, high) where the polynomial changes its sign, increasing: its real roots of
/// odd multiplicity. The roots are searched between neighbouring sign changes of the derivative,
/// where the polynomial is monotone.
std::vector<double> sign_changes(const Polynomial& polynomial, double low, double high);

/// Cauchy's bound of the roots, 1 + max |a_n / a_degree|: every root of the polynomial has a
/// modulus below this bound. The bound is 0 for a constant polynomial.
double root_modulus_bound(const Polynomial& polynomial);

}  // namespace fpkcheck::numerics
