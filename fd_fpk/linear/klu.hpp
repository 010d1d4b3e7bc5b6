#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// Sparse LU factorisations by KLU, ordered by nested dissection (CHOLMOD with METIS). The ordering
/// is found once, and so are the pivots: all matrices that one object factors must have the same
/// pattern. A matrix for which the pivots of the one before are no good gets its own.
class KluFactorisation {
 public:
  KluFactorisation();
  ~KluFactorisation();
  KluFactorisation(KluFactorisation&&) noexcept;
  KluFactorisation& operator=(KluFactorisation&&) noexcept;

  /// Factors `matrix`. False when there is no factorisation; then solve must not be called.
  bool factor(const SparseColumns& matrix);
  /// Why it failed and what to do; empty when it succeeded.
  std::string failure() const;
  /// Entries of both factors.
  long entries() const;

  /// Replaces b by the solution x of A x = b.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  struct Handles;
  bool refactor(const SparseColumns& matrix);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
