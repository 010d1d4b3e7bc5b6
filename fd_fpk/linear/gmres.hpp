#pragma once

#include <Eigen/Core>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

/// Stores an exception that a callback of SUNDIALS throws. Exceptions must not propagate through
/// the C stack frames of SUNDIALS. The callback returns a flag instead, and the caller of SUNDIALS
/// rethrows the exception.
class CallbackExceptionStore {
 public:
  /// Negative flag of a callback, which SUNDIALS treats as an unrecoverable error
  static constexpr int kUnrecoverable = -1;

  /// Calls `callback` and returns the flag, or kUnrecoverable if the callback throws.
  template <class Callback>
  int invoke(const Callback& callback) noexcept {
    try {
      return callback();
    } catch (...) {
      // Only the first exception is kept, since later exceptions may be consequences of the first.
      if (!thrown_) thrown_ = std::current_exception();
      return kUnrecoverable;
    }
  }

  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

/// A linear map A on vectors: the function returns A x.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// Function that replaces a right-hand side by the approximate solution of a linear system.
using ApproximateSolve = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

struct GmresResult {
  std::optional<Eigen::VectorXd> solution;
  long iterations = 0;
  std::string failure = {};  ///< reason why GMRES found no solution; empty after a success
};

/// Solves A x = b by GMRES of SUNDIALS (SUNLinSol_SPGMR), starting at x = 0. The preconditioner
/// acts from the right, so that the residual of the unpreconditioned system is the stopping
/// criterion.
///
/// @param weights weights w of the norm of a vector x, (sum_i (w_i x_i)^2)^(1/2)
/// @param tolerance largest accepted ||A x - b|| / ||b||
/// @throws std::runtime_error if SUNDIALS cannot allocate its memory; also rethrows every exception
/// of `a` and `approximate_solve`
GmresResult gmres(const LinearMap& a, const ApproximateSolve& approximate_solve,
                  const Eigen::VectorXd& b, const Eigen::VectorXd& weights, double tolerance,
                  const Deadline& deadline = Deadline::unlimited());

}  // namespace fpkcheck::fd_fpk
