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
  std::string failure = {};  ///< reason why there are no averages; empty if there are averages
  double krylov_seconds = 0;
};

/// The stationary density without time steps: the null vector of L with mass 1, start + d. The
/// vector `start` has mass 1, and GMRES solves L d = -L start for the correction d, with a
/// preconditioner of one factorisation. L conserves mass, so that all residuals and d have mass 0:
/// the singular system is consistent at every step.
/// @param deadline time limit of the GMRES iteration
NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start,
                       const Deadline& deadline = Deadline::unlimited());

/// The null vector with mass 1 by inverse iteration with KLU factors of the whole matrix L. For
/// unstable operators, which no simple preconditioner approximates. A solver that does not test
/// well-posedness would return this vector as its density.
/// @param frequency frequency of the oscillator, the unit of residuals
NullVector null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                            const Eigen::VectorXd& start, double frequency);

/// Eigenvalues of the semi-discrete operator L with the largest real parts: the growth or decay
/// rates, per unit time, of the slowest modes of dP/dt = L P.
struct RightmostEigenvalues {
  /// Eigenvalues in the order of decreasing real parts. A conjugate pair has one entry, the
  /// eigenvalue in the upper half-plane.
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< eigenvector of the first value, with norm 1
  double residual = 0;  ///< largest ||L v - value v|| / ||v|| of the returned pairs, per unit time
  long factorisations = 0;  ///< number of factorisations by KLU
  long solves = 0;
  std::string failure = {};  ///< reason why there are no eigenvalues, and what to do
};

/// The `count` rightmost eigenvalues of the whole operator, including jumps, by shift-invert
/// Arnoldi (Spectra) on KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost: an oscillating mode with a
/// large imaginary part may have a larger real part. Therefore the eigenvalues found with the shift
/// are checked by the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),   |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// with m just left of the last eigenvalue found, and sigma so far right that a larger real part of
/// an eigenvalue of L means a larger modulus of the eigenvalue of C. The check is repeated until no
/// new eigenvalue is found. (Meerbergen, Spence and Roose, BIT 34 (1994) 409-423.) The check is
/// strong evidence, not a proof. The check may miss a mode that oscillates many times faster than 8
/// growth rates or frequencies and decays hardly more slowly than the values found.
///
/// @param growth expected rightmost real part: the largest rate of the excitation's symbol,
/// fastest_growing_wave, or 0 for a stable excitation
/// @param frequency frequency of the oscillator, sqrt(k_eq), the unit of rates
RightmostEigenvalues rightmost_eigenvalues(const FokkerPlanckOperator& op, double growth,
                                           double frequency, int count);

}  // namespace fpkcheck::fd_fpk
