#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

struct NullVector {
  std::optional<Eigen::VectorXd> averages;
  long iterations = 0;       ///< iterations of GMRES
  std::string failure = {};  ///< reason why GMRES found no cell averages; empty after a success
  double krylov_seconds = 0;
};

/// Computes the stationary density without time steps, as the null vector start + d of the operator
/// L with mass 1. The vector `start` has mass 1, and GMRES solves L d = -L start for the correction
/// d, with a preconditioner that is factored once. The operator L conserves mass, so that all
/// residuals and the correction d have mass 0: the singular system is consistent at every step of
/// GMRES.
/// @param deadline time limit of the GMRES iteration
NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start,
                       const Deadline& deadline = Deadline::unlimited());

/// Computes the null vector of mass 1 of an unstable operator by inverse iteration with KLU factors
/// of the whole matrix L, since no simple preconditioner approximates an unstable operator. A
/// solver that does not test well-posedness would return this null vector as its density.
/// @param frequency frequency of the oscillator, the unit of residuals
NullVector null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                            const Eigen::VectorXd& start, double frequency);

/// Eigenvalues of the semi-discrete operator L with the largest real parts: the growth or decay
/// rates, per unit time, of the slowest modes of dP/dt = L P.
struct RightmostEigenvalues {
  /// Eigenvalues in the order of decreasing real parts. A conjugate pair of eigenvalues has one
  /// entry, the eigenvalue in the upper half-plane.
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< eigenvector of the first value, with norm 1
  double residual = 0;      ///< largest ||L v - value v|| / ||v|| of the eigenpairs, per unit time
  long factorisations = 0;  ///< number of factorisations by KLU
  long solves = 0;
  std::string failure = {};  ///< reason why there are no eigenvalues, and what to do
};

/// The `count` rightmost eigenvalues of the whole operator, including jumps, by shift-invert
/// Arnoldi (Spectra) on KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost: an oscillating mode with a
/// large imaginary part may have a larger real part. Therefore the eigenvalues that Arnoldi finds
/// with the shift sigma are checked by the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),   |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// with m just left of the last eigenvalue found, and the shift sigma so far right that a larger
/// real part of an eigenvalue of L means a larger modulus of the eigenvalue of C. The check is
/// repeated until no new eigenvalue is found (Meerbergen, Spence and Roose, BIT 34 (1994) 409-423).
/// The check by the Cayley transform is strong evidence, not a proof: the check may miss a mode
/// that oscillates many times faster than 8 growth rates or frequencies and decays hardly more
/// slowly than the values found.
///
/// @param growth expected rightmost real part: the largest rate of the excitation's symbol,
/// fastest_growing_wave, or 0 for a stable excitation
/// @param frequency frequency of the oscillator, sqrt(k_eq), the unit of rates
RightmostEigenvalues rightmost_eigenvalues(const FokkerPlanckOperator& op, double growth,
                                           double frequency, int count);

}  // namespace fpkcheck::fd_fpk
