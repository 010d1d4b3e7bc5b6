#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// Eigenvalues of the semi-discrete operator L with the largest real parts: the growth or decay
/// rates, per unit time, of the slowest modes of dP/dt = L P.
struct RightmostEigenvalues {
  /// By decreasing real part; of a conjugate pair the value in the upper half-plane.
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< eigenvector of the first value, with norm 1
  double residual = 0;  ///< largest ||L v - value v|| / ||v|| of the returned pairs, per unit time
  long factorisations = 0;  ///< factorisations by KLU
  long solves = 0;
  std::string failure = {};  ///< reason for the absence of eigenvalues, and what to do
};

/// The `count` rightmost eigenvalues of the whole operator, including jumps, by shift-invert
/// Arnoldi (Spectra) on KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost: an oscillating mode with a
/// large imaginary part may have a larger real part. The result of the shift is therefore tested
/// with the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),   |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// with m just left of the last value and sigma so far right that the eigenvalues of C are ordered
/// by the real parts of those of L. The test is repeated until it finds no new eigenvalue.
/// (Meerbergen, Spence and Roose, BIT 34 (1994) 409-423.) The test is strong evidence, not a proof.
/// It may miss a mode that oscillates many times faster than 8 growth rates or frequencies and
/// decays hardly more slowly than the values found.
///
/// @param growth expected rightmost real part: the largest rate of the excitation's symbol,
/// largest_growth, or 0 for a stable excitation
/// @param frequency of the oscillator, sqrt(k_eq): the unit of rates
RightmostEigenvalues rightmost_eigenvalues(const FokkerPlanckOperator& op, double growth,
                                           double frequency, int count);

}  // namespace fpkcheck::fd_fpk
