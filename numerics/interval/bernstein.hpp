#pragma once

#include <array>
#include <span>
#include <vector>

#include "numerics/interval/interval.hpp"

/// Polynomials of t on [0, 1] in Bernstein form, sum_j b_j C(n, j) t^j (1-t)^(n-j), whose
/// coefficients b_j are intervals. The values of such a polynomial lie between its smallest and its
/// largest coefficient. Farouki, Comput. Aided Geom. Des. 29 (2012) 379.
namespace fpkcheck::numerics {

using BernsteinCoefficients = std::vector<Interval>;  ///< b_0 .. b_n; degree n = size() - 1

/// The binomial coefficient C(n, j), exact for n <= 40.
double binomial_coefficient(int n, int j);

/// Degree elevation: the Bernstein coefficients of the same polynomial in the Bernstein basis of a
/// higher degree.
BernsteinCoefficients elevate_degree(std::span<const Interval> b, int degree);
/// Bernstein coefficients of the product of two polynomials.
BernsteinCoefficients bernstein_product(std::span<const Interval> a, std::span<const Interval> b);
/// Bernstein coefficients of the derivative with respect to t.
BernsteinCoefficients bernstein_derivative(std::span<const Interval> b);
/// The value of the polynomial at t in [0, 1], computed with de Casteljau's algorithm.
Interval bernstein_value(std::span<const Interval> b, const Interval& t);

/// Bernstein coefficients of the polynomial sum_k a_k t^k, in the same degree.
BernsteinCoefficients bernstein_from_power_coefficients(std::span<const Interval> a);
/// Power coefficients a_k of the polynomial sum_k a_k t^k whose Bernstein coefficients are given.
BernsteinCoefficients power_coefficients_from_bernstein(std::span<const Interval> b);
/// Bernstein coefficients of the polynomial sum_k a_k (x - origin)^k on the segment x = from + t
/// (to - from), 0 <= t <= 1.
BernsteinCoefficients bernstein_on_segment(std::span<const double> a, const Interval& origin,
                                           const Interval& from, const Interval& to);

}  // namespace fpkcheck::numerics
