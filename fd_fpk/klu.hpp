#pragma once

#include <Eigen/Core>
#include <memory>

#include "fd_fpk/operator.hpp"

namespace fpkcheck::fd_fpk {

/// A sparse LU factorisation by KLU with AMD ordering.
class KluFactorisation {
 public:
  /// Factors `matrix`, which must outlive this object.
  explicit KluFactorisation(const SparseColumns& matrix);
  ~KluFactorisation();
  KluFactorisation(KluFactorisation&&) noexcept;
  KluFactorisation& operator=(KluFactorisation&&) noexcept;

  /// False when the matrix is singular to working precision; then solve must not be called.
  bool succeeded() const;

  /// Replaces b by the solution x of A x = b.
  void solve_in_place(Eigen::VectorXd& b) const;

  /// Entries of L and U together.
  long entries() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
