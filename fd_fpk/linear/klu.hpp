#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// Computes an ordering of the unknowns that reduces the fill-in of the LU factors, by nested
/// dissection of the graph of A + A^T (CHOLMOD with METIS). The ordering depends only on the
/// positions of the nonzero entries of the matrix A. Recent orderings are cached, since the same
/// grid sizes recur in error estimates and at neighbouring points of a sweep.
/// fill_reducing_ordering() is thread-safe.
/// @return the ordering; empty on failure
std::vector<std::int64_t> fill_reducing_ordering(const SparseColumnMatrix& matrix);

/// Sparse LU factorisations by KLU with a nested-dissection ordering (CHOLMOD with METIS). The
/// ordering is computed once, for the first matrix: all matrices that one object factors must have
/// nonzero entries at the same positions. The pivots of the previous matrix are reused; a matrix
/// for which the old pivots are numerically unsuitable is factored with new pivots.
class KluFactorisation {
 public:
  KluFactorisation();
  ~KluFactorisation();
  KluFactorisation(KluFactorisation&&) noexcept;
  KluFactorisation& operator=(KluFactorisation&&) noexcept;

  /// Factors `matrix`. Returns false on failure; after a failure solve_in_place() must not be
  /// called.
  bool factorise(const SparseColumnMatrix& matrix);
  /// The reason why the factorisation failed, and what to do; empty after a success.
  std::string failure_reason() const;
  /// Number of entries of both triangular factors.
  long factor_entry_count() const;

  /// Replaces b by the solution x of A x = b.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  struct Handles;
  bool refactor(const SparseColumnMatrix& matrix);
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
