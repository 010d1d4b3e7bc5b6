#pragma once

#include <memory>

#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Solves systems with I - gamma L, or with L itself, approximately: KLU on a sparse operator of
/// the same equation and of low order. The jumps, which would fill the factors, are left out and a
/// weak diffusion put in their place; a small loss of mass keeps the matrix regular. GMRES corrects
/// for all three. The number of its iterations hardly grows with the grid (docs/performance.md).
class Preconditioner {
 public:
  /// @param order of L. An even one is taken as it is, and not replaced by the third: centred
  ///        differences lack the upwind dissipation, and GMRES would not get along with it.
  Preconditioner(const problem::Problem& problem, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order = 3);
  /// @param loss problem::Scales::slowest_decay, where it is known
  Preconditioner(const problem::System& system, double loss, const Excitation& excitation,
                 problem::Impact impact, const Grid& grid, int order);

  /// Factors I - gamma M. False when it failed; see failure(). For gamma that is long against the
  /// slowest decay it is nearly -gamma M: right after factor_stationary() those factors are kept, and
  /// GMRES corrects for the rest, as it does for the loss.
  bool factor(double gamma);
  /// Factors M.
  bool factor_stationary();
  std::string failure() const { return klu_.failure(); }

  long factorisations() const { return factorisations_; }  ///< so far
  /// Time spent in them, in seconds.
  double factor_seconds() const { return factor_seconds_; }
  /// Entries of the factors.
  long entries() const { return klu_.entries(); }

  /// Replaces b by the solution.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  bool factored_by_klu(const SparseColumns& matrix);

  double loss_;
  SparseColumns approximation_;  // M, with its diagonal stored
  SparseColumns factored_;
  KluFactorisation klu_;
  bool of_stationary_ = false;  // the factors are those of M
  double multiple_ = 1;  // of the factored matrix, which takes the place of the one asked for
  long factorisations_ = 0;
  double factor_seconds_ = 0;
};

}  // namespace fpkcheck::fd_fpk
