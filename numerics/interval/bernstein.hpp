#pragma once

#include <array>
#include <span>
#include <vector>

#include "numerics/interval/interval.hpp"

/// Polynomials on [0, 1] in Bernstein form, sum_j b_j C(n, j) t^j (1-t)^(n-j), with interval
/// coefficients. The values lie between the smallest and the largest coefficient. Farouki, Comput.
/// Aided Geom. Des. 29 (2012) 379.
namespace fpkcheck::numerics {

using BernsteinCoefficients = std::vector<Interval>;  ///< the degree is size() - 1

/// C(n, j), exact for n <= 40.
double binomial(int n, int j);

/// Degree elevation: the coefficients of the same polynomial in a higher degree.
BernsteinCoefficients elevate_degree(std::span<const Interval> b, int degree);
/// The product of two polynomials.
BernsteinCoefficients product(std::span<const Interval> a, std::span<const Interval> b);
/// The derivative by t.
BernsteinCoefficients derivative(std::span<const Interval> b);
/// The value at t in [0, 1], by de Casteljau's algorithm.
Interval value(std::span<const Interval> b, const Interval& t);

/// Bernstein coefficients of sum_k a_k t^k, same degree.
BernsteinCoefficients bernstein_from_powers(std::span<const Interval> a);
/// Power coefficients a_k of a Bernstein form.
BernsteinCoefficients powers_from_bernstein(std::span<const Interval> b);
/// Bernstein coefficients of sum_k a_k (x - origin)^k on the segment x = from + t (to - from).
BernsteinCoefficients bernstein_on_segment(std::span<const double> a, const Interval& origin,
                                           const Interval& from, const Interval& to);

}  // namespace fpkcheck::numerics
