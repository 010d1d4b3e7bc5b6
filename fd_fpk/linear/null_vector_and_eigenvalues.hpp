#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"

namespace fpkcheck::fd_fpk {

struct NullVectorResult {
  std::optional<Eigen::VectorXd> averages;
  long iterations = 0;
  std::string failure = {};  ///< reason why GMRES found no null vector; empty after a success
  double krylov_seconds = 0;
};

/// Computes the stationary density without time steps, as the null vector start + d of the operator
/// L with mass 1. GMRES solves L d = -L start for the correction d, where the vector `start` has
/// mass 1. The operator L conserves mass, so that all residuals have mass 0 and the singular system
/// is consistent.
NullVectorResult find_null_vector(
    const FokkerPlanckOperator& op, Preconditioner& preconditioner,
    const Eigen::VectorXd& initial_averages,
    const base::Deadline& deadline = base::Deadline::without_time_limit());

/// Computes the null vector of mass 1 of an unstable operator by inverse iteration with KLU factors
/// of the whole matrix L. A solver without a test of well-posedness would return the null vector of
/// an unstable operator.
/// @param frequency frequency of the oscillator, the unit of residuals
NullVectorResult find_null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                                       const Eigen::VectorXd& initial_averages,
                                                       double frequency);

/// Eigenvalues of the operator L with the largest real parts, the rates of the slowest modes.
struct RightmostEigenvalues {
  /// Eigenvalues by decreasing real part, one for each conjugate pair, in the upper half-plane
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< eigenvector of the first value, with norm 1
  double residual = 0;  ///< largest ||L v - value v|| / ||v|| of the eigenpairs, per unit time
  long factorisations = 0;
  long solves = 0;
  std::string failure = {};  ///< reason why the computation gave no eigenvalues, and what to do
};

/// Computes the `count` rightmost eigenvalues of the whole operator, including jumps, by
/// shift-invert Arnoldi (Spectra) with KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost eigenvalues: an oscillating
/// mode, far from the shift, may have a larger real part. The eigenvalues that Arnoldi finds with
/// the shift sigma are therefore checked by the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),   |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// The real number m is just left of the last eigenvalue of L that was found. The shift sigma is so
/// large that eigenvalues of L with larger real parts give eigenvalues of C with larger modulus.
/// The check by the Cayley transform is repeated until no new eigenvalue is found (Meerbergen,
/// Spence and Roose, BIT 34 (1994) 409-423). The check of the eigenvalues does not prove
/// completeness: it may miss a mode that oscillates many times faster than eight times the growth
/// rate or the oscillator's frequency.
///
/// @param excitation_growth_rate expected rightmost real part: the growth rate of the excitation; 0
/// if stable
/// @param frequency frequency of the oscillator, sqrt(k_eq), the unit of rates
RightmostEigenvalues find_rightmost_eigenvalues(const FokkerPlanckOperator& op,
                                                double excitation_growth_rate, double frequency,
                                                int count);

}  // namespace fpkcheck::fd_fpk
