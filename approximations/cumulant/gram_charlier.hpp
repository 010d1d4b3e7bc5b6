#pragma once

#include <Eigen/Core>

namespace fpkcheck::cumulant {

/// Returns the moments E[x^a w^b], a + b <= `max_order`, of two variables with given cumulants, as
/// the entries (a, b) of a matrix. The cumulants outside the matrix `cumulants` are 0. The moments
/// follow from the recursion, with binomial coefficients C,
///
///     E[x^(a+1) w^b] = sum_{i <= a, j <= b} C(a, i) C(b, j) kappa_{i+1, j} E[x^(a-i) w^(b-j)].
///
/// @param cumulants cumulants kappa_{p, q} as the entries (p, q) of a square matrix
Eigen::MatrixXd moments_from_cumulants(const Eigen::MatrixXd& cumulants, int max_order);

/// Returns the coefficients a_ij of the polynomial P of the Gram-Charlier A series in two
/// standardised, uncorrelated variables, whose density is phi(x) phi(w) P(x, w) with the standard
/// normal density phi:
///
///     P = sum_{i+j <= n} E[He_i(x) He_j(w)] / (i! j!) He_i(x) He_j(w) = sum_ij a_ij x^i w^j.
///
/// The density has the given moments up to the order n.
/// @param moments standardised moments E[x^a w^b] as entries (a, b), at least up to the order n
Eigen::MatrixXd gram_charlier_polynomial(const Eigen::MatrixXd& moments, int order);

/// Returns E[|x|^k] of a standard normal x, which is (k-1)!! for even k.
double absolute_normal_moment(int k);

/// Returns E[sgn(x) x^a w^b] under the Gram-Charlier density with the coefficients of P.
/// @pre a + b is odd, and P(x, w) = P(-x, -w)
double half_plane_moment(const Eigen::MatrixXd& polynomial, int a, int b);

}  // namespace fpkcheck::cumulant
