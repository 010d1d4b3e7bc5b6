#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// Eigenvalues of the semi-discrete operator L with the largest real parts: the rates, per unit
/// time, at which dP/dt = L P grows, or forgets its start.
struct RightmostEigenvalues {
  /// By decreasing real part; of a conjugate pair the one above the real axis.
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< of the first one, of norm 1
  double residual = 0;      ///< largest ||L v - value v|| / ||v|| of those given, per unit time
  long factorisations = 0;  ///< by KLU
  long solves = 0;
  std::string failure = {};  ///< why there are none, and what to do
};

/// The `count` rightmost eigenvalues of the whole operator, jumps and all, by shift-invert Arnoldi
/// (Spectra) on KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost ones: an oscillating mode far
/// up the imaginary axis may lie further to the right. So what the shift finds is put to the test
/// of the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),    |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// with m just left of the last one found and a sigma so far right that the eigenvalues of C rank
/// by the real parts of those of L. The test is repeated until it finds nothing new. (Meerbergen,
/// Spence and Roose, BIT 34 (1994) 409-423.) It is strong evidence, not a proof: a mode that turns
/// many times faster than 8 growth rates or frequencies and decays hardly more slowly than those
/// found may escape.
///
/// @param growth where the rightmost one is expected: the largest rate of the excitation's symbol,
///        largest_growth, or 0 when nothing grows
/// @param frequency of the oscillator, sqrt(k_eq): the unit in which rates are small or large
RightmostEigenvalues rightmost_eigenvalues(const FokkerPlanckOperator& op, double growth,
                                           double frequency, int count);

}  // namespace fpkcheck::fd_fpk
