#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "fd_fpk/operator/fokker_planck_operator.hpp"

namespace fpkcheck::fd_fpk {

/// Computes an ordering of the unknowns with little fill-in of the LU factors, by nested dissection
/// of the graph of A + A^T (CHOLMOD with METIS). The ordering depends only on the positions of the
/// nonzero entries of the matrix A. Recent orderings are cached, since error estimates and sweeps
/// solve repeatedly on grids of equal size. fill_reducing_ordering() is thread-safe.
/// @return ordering of the unknowns; empty on failure
std::vector<int> fill_reducing_ordering(const SparseColumnMatrix& matrix);

/// Sparse LU factorisation by KLU with a nested-dissection ordering (CHOLMOD with METIS). All
/// matrices that one KluFactorisation factors must have nonzero entries at the same positions,
/// since the ordering is computed once. The factorisation reuses the pivots of the previous matrix
/// if these pivots are numerically suitable.
class KluFactorisation {
 public:
  KluFactorisation();
  ~KluFactorisation();
  KluFactorisation(KluFactorisation&&) noexcept;
  KluFactorisation& operator=(KluFactorisation&&) noexcept;

  /// Factors `matrix`; returns false on failure, after which solve_in_place() must not be called.
  bool factorise(const SparseColumnMatrix& matrix);
  /// Returns the reason why the factorisation failed, and a remedy; empty after a success.
  std::string failure_reason() const;
  long factor_entry_count() const;

  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;
  /// Solves the linear system with the transposed matrix.
  void solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  struct Handles;
  bool factorise_with_old_pivots(const SparseColumnMatrix& matrix);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
