#pragma once

#include <memory>

#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Preconditioner for systems with I - gamma L, or with L itself. KLU factors a sparse matrix M,
/// which approximates L in three respects: the differences of M have low order; a weak diffusion
/// replaces the velocity jumps, whose dense matrix would fill the factors; a small loss of mass
/// makes the matrix M regular. GMRES corrects the errors of the three approximations. The number of
/// GMRES iterations hardly increases with the number of cells (docs/performance.md).
class Preconditioner {
 public:
  /// @param order the order of the operator L. If the order of L is odd, the preconditioner M has
  /// order 3. If the order of L is even, M has the order of L: centred differences have no upwind
  /// dissipation, and GMRES would not converge with a dissipative preconditioner.
  Preconditioner(const problem::Problem& problem, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order = 3);
  /// @param loss rate of the mass loss that makes M regular:
  /// problem::MotionScales::slowest_decay_rate, if known
  Preconditioner(const problem::System& system, double loss, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order);

  /// Factors I - gamma M. Returns false on failure; see failure_reason(). If gamma is much longer
  /// than the slowest decay time, I - gamma M is nearly -gamma M. For so long a gamma, directly
  /// after factor_stationary(), the factors of M are reused, and GMRES corrects the difference.
  bool factorise(double gamma);
  /// Factors M. Returns false on failure; see failure_reason().
  bool factor_stationary();
  std::string failure_reason() const { return klu_.failure_reason(); }

  long factorisation_count() const { return factorisations_; }  ///< number of factorisations so far
  /// Total time of the factorisations, in seconds.
  double factor_seconds() const { return factor_seconds_; }
  /// Number of entries of both triangular factors.
  long factor_entry_count() const { return klu_.factor_entry_count(); }

  /// Replaces the right-hand side b by the solution of the factored system.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  bool factor_with_klu(const SparseColumnMatrix& matrix);

  double loss_;
  SparseColumnMatrix approximation_;  // the matrix M, with all diagonal entries stored
  SparseColumnMatrix factored_;
  KluFactorisation klu_;
  bool are_stationary_ = false;  // whether the stored factors are factors of M
  double matrix_scale_ = 1;      // ratio of the requested matrix to the factored matrix
  long factorisations_ = 0;
  double factor_seconds_ = 0;
};

}  // namespace fpkcheck::fd_fpk
