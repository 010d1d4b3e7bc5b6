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

/// Computes the stationary density without time steps, as the null vector start + d with mass 1 of
/// the Fokker-Planck operator L. GMRES solves L d = -L start for the correction d, where the vector
/// `start` has mass 1. The Fokker-Planck operator L conserves mass, so that all residuals have mass
/// 0 and the singular linear system is consistent.
NullVectorResult find_null_vector(
    const FokkerPlanckOperator& op, Preconditioner& preconditioner,
    const Eigen::VectorXd& initial_averages,
    const base::Deadline& deadline = base::Deadline::without_time_limit());

/// Computes the null vector of mass 1 of an unstable operator by inverse iteration with KLU factors
/// of the whole matrix of the operator. A solver without a test of well-posedness would return this
/// null vector of an unstable operator.
/// @param frequency frequency of the oscillator, in units of which residuals are measured
NullVectorResult find_null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                                       const Eigen::VectorXd& initial_averages,
                                                       double frequency);

/// Eigenvalues of the operator L with the largest real parts, the rates of the slowest modes.
struct RightmostEigenvalues {
  /// Eigenvalues in the order of decreasing real parts; of each conjugate pair only the eigenvalue
  /// in the upper half-plane
  std::vector<std::complex<double>> values = {};
  Eigen::VectorXcd vector = {};  ///< eigenvector of the first value, with norm 1
  double residual = 0;  ///< largest ||L v - value v|| / ||v|| of the eigenpairs, per unit time
  long factorisations = 0;
  long solves = 0;
  std::string failure = {};  ///< reason why the computation gave no eigenvalues, and what to do
};

/// Computes the `count` rightmost eigenvalues of the whole Fokker-Planck operator, including
/// velocity jumps, by shift-invert Arnoldi iterations (Spectra) with KLU factors.
///
/// The eigenvalues nearest to a real shift need not be the rightmost eigenvalues: an oscillating
/// mode, whose eigenvalue is far from the shift, may have a larger real part. The eigenvalues that
/// the Arnoldi method finds with the shift sigma are therefore checked by the Cayley transform
///
///     C = (L - sigma)^-1 (L - (2 m - sigma)),   |eigenvalue of C| > 1 <=> Re(eigenvalue of L) > m,
///
/// In the Cayley transform C, the real number m is slightly less than the real part of the last
/// eigenvalue of L that was found. The shift sigma is so large that eigenvalues of the operator L
/// with larger real parts give eigenvalues of the Cayley transform C with larger modulus. The check
/// by the Cayley transform is repeated until no new eigenvalue is found (Meerbergen, Spence and
/// Roose, BIT 34 (1994) 409-423). The check by the Cayley transform may miss a mode whose angular
/// frequency is much larger than eight times the growth rate or the frequency of the oscillator.
///
/// @param excitation_growth_rate growth rate of the excitation, an estimate of the largest real
/// part of the eigenvalues; 0 if the excitation is stable
/// @param frequency frequency sqrt(k_eq) of the oscillator, in units of which rates are measured
RightmostEigenvalues find_rightmost_eigenvalues(const FokkerPlanckOperator& op,
                                                double excitation_growth_rate, double frequency,
                                                int count);

}  // namespace fpkcheck::fd_fpk
