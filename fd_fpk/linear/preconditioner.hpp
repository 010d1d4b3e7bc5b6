#pragma once

#include <memory>

#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Approximate solves with I - gamma L, or with L itself: KLU on a sparse low-order operator of the
/// same equation. A weak diffusion replaces the jumps, which would fill the factors; a small loss
/// of mass makes the matrix regular. GMRES corrects for all three approximations. Its number of
/// iterations hardly increases with the grid (docs/performance.md).
class Preconditioner {
 public:
  /// @param order of L. Even orders are used unchanged instead of the third order: centred
  /// differences lack the upwind dissipation, and GMRES would not converge with a dissipative
  /// preconditioner.
  Preconditioner(const problem::Problem& problem, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order = 3);
  /// @param loss problem::Scales::slowest_decay_rate, where known
  Preconditioner(const problem::System& system, double loss, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order);

  /// Factors I - gamma M. Returns false on failure; see failure(). For gamma much longer than the
  /// slowest decay time the matrix is nearly -gamma M: directly after factor_stationary() those
  /// factors are reused, and GMRES corrects for the difference, as for the loss.
  bool factor(double gamma);
  /// Factors M.
  bool factor_stationary();
  std::string failure() const { return klu_.failure(); }

  long factorisations() const { return factorisations_; }  ///< number of factorisations so far
  /// Total time of the factorisations, in seconds.
  double factor_seconds() const { return factor_seconds_; }
  /// Number of entries of the factors.
  long entries() const { return klu_.entries(); }

  /// Replaces b by the solution.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  bool factor_with_klu(const SparseColumns& matrix);

  double loss_;
  SparseColumns approximation_;  // M, with its diagonal stored
  SparseColumns factored_;
  KluFactorisation klu_;
  bool are_stationary_ = false;  // true if the factors are those of M
  double matrix_scale_ = 1;      // the requested matrix is this multiple of the factored matrix
  long factorisations_ = 0;
  double factor_seconds_ = 0;
};

}  // namespace fpkcheck::fd_fpk
