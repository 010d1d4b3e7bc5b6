#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::numerics {

/// The real roots of a polynomial within (low, high), increasing, those of even order left out: where
/// it changes its sign. Between the roots of its derivative it is monotone.
std::vector<double> sign_changes(const Polynomial& polynomial, double low, double high);

/// 1 + the largest |a_n / a_degree|: no root is farther from 0 (Cauchy). 0 of a constant.
double root_bound(const Polynomial& polynomial);

}  // namespace fpkcheck::numerics
