#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

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

  /// False when there is no factorisation; then solve must not be called.
  bool succeeded() const;
  /// Why it failed and what to do; empty when it succeeded.
  std::string failure() const;

  /// Replaces b by the solution x of A x = b.
  void solve_in_place(Eigen::VectorXd& b) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace fpkcheck::fd_fpk
