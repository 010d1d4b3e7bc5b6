#pragma once

#include <memory>

#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Preconditioner for linear systems with the matrix I - gamma L or with the Fokker-Planck operator
/// L itself. KLU factors a sparse matrix M that approximates the Fokker-Planck operator L. The
/// preconditioner matrix M has finite differences of low order, and a weak diffusion instead of the
/// dense matrix of the velocity jumps. A small rate of mass loss makes the preconditioner matrix M
/// nonsingular. With the preconditioner, the number of GMRES iterations hardly increases with the
/// number of cells (docs/performance.md).
class Preconditioner {
 public:
  /// @param order order of accuracy of the operator L. For odd orders of L the preconditioner
  /// matrix M has order 3. For even orders the preconditioner matrix M has the order of L, since
  /// centred differences have no upwind dissipation and GMRES would not converge with a dissipative
  /// preconditioner.
  Preconditioner(const problem::Problem& problem, const DiscretisedExcitation& excitation,
                 problem::ImpactCondition impact, const PhasePlaneGrid& grid, int order = 3);
  /// @param mass_loss_rate rate of mass loss that makes the preconditioner matrix M nonsingular,
  /// such as problem::MotionScales::slowest_decay_rate
  Preconditioner(const problem::System& system, double mass_loss_rate,
                 const DiscretisedExcitation& excitation, problem::ImpactCondition impact,
                 const PhasePlaneGrid& grid, int order);

  /// Factors the matrix I - gamma M of the preconditioner and returns false on failure; see
  /// failure_reason(). If gamma is at least three times the slowest decay time, the function reuses
  /// present factors of M, since I - gamma M is nearly -gamma M.
  bool factorise_newton_matrix(double gamma);
  /// Factors the preconditioner matrix M, unless the present factors are the factors of M, and
  /// returns false on failure; see failure_reason().
  bool factorise_stationary();
  std::string failure_reason() const { return klu_.failure_reason(); }

  long factorisation_count() const { return factorisations_; }
  double factor_seconds() const { return factor_seconds_; }
  long factor_entry_count() const { return klu_.factor_entry_count(); }

  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;
  void solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  bool factor_with_klu(const SparseColumnMatrix& matrix);

  double mass_loss_rate_;
  SparseColumnMatrix approximation_;  // the matrix M, with all diagonal entries stored
  SparseColumnMatrix factored_;
  KluFactorisation klu_;
  bool are_stationary_ = false;  // whether the stored factors are factors of M
  double matrix_scale_ = 1;      // ratio of the requested matrix to the factored matrix
  long factorisations_ = 0;
  double factor_seconds_ = 0;
};

}  // namespace fpkcheck::fd_fpk
