#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/functionals/shifted_system.hpp"

namespace fpkcheck::fd_fpk {

/// Reduced model of the transfer functions h(s) = <w, (s - L)^-1 b> of a generator L or its
/// adjoint, by Arnoldi iteration with the real matrix B = (sigma - L)^-1 from the vector b. With
/// the basis V of the Krylov space, B V = V H + .., and
///
///     (s - L)^-1 = (1 - (sigma - s) B)^-1 B,    h(s) ~ <w, V (1 - (sigma - s) H)^-1 H V^T b>.
///
/// One factorisation of sigma - L suffices for all s. If b has mass 0 and L conserves mass, all
/// vectors of the Krylov space have mass 0, and s = 0 is not singular. The iteration would amplify
/// rounding errors of the mass. Multiples of the stationary density are therefore subtracted, so
/// that every vector has mass 0.
class ReducedResolvent {
 public:
  /// @param system linear systems of sigma - L, which must outlive this object
  /// @param stationary stationary density of mass 1 if b has mass 0; otherwise empty
  ReducedResolvent(const ShiftedLinearSystem& system, const Eigen::VectorXd& b,
                   Eigen::VectorXd stationary = {});

  /// Adds `count` vectors to the basis.
  /// @return whether the linear systems were solved; otherwise failure_reason() gives the reason
  bool add_krylov_basis_vectors(int count, const base::Deadline& deadline);

  int size() const { return size_; }
  const std::string& failure_reason() const { return failure_; }

  /// Returns the transfer function h(s) of the functional w at the given points s. The call also
  /// determines the accuracy of the linear systems of further vectors: an error of vector k enters
  /// the transfer function with the coefficient of vector k, and the coefficients decrease with k
  /// (Simoncini and Szyld, SIAM Journal on Scientific Computing 25 (2003) 454).
  Eigen::VectorXcd transfer_function_values(const Eigen::VectorXd& functional,
                                            const Eigen::VectorXcd& points);

  /// Returns the solution x of (s - L) x = b for a real s, with the accuracy of
  /// transfer_function_values().
  Eigen::VectorXd shifted_solution(double s) const;

  /// Eigenvalues a of the reduced model of L, and coefficients c of the decaying modes in
  /// <w, exp(L t) b> = sum c exp(a t).
  struct Modes {
    Eigen::VectorXcd rates, coefficients;
  };
  /// @param basis_size number of basis vectors of the reduced model, at most size(); all if absent
  Modes reduced_model_modes(const Eigen::VectorXd& functional,
                            std::optional<int> basis_size = {}) const;

 private:
  const ShiftedLinearSystem& system_;
  Eigen::VectorXd stationary_;
  double norm_;            // norm of b
  int size_ = 0;           // number of columns of H
  Eigen::MatrixXd basis_;  // columns V, one more than size_
  Eigen::MatrixXd hessenberg_;
  double weight_of_last_ = 1;  // coefficient of the last vector, relative to all coefficients
  std::string failure_ = {};
};

}  // namespace fpkcheck::fd_fpk
