#pragma once

#include <exception>
#include <utility>

namespace fpkcheck::fd_fpk {

/// Stores an exception that is thrown in a callback of SUNDIALS. Exceptions must not propagate
/// through the C frames of SUNDIALS: the callback returns a flag instead, and the caller of
/// SUNDIALS rethrows the exception.
class CallbackException {
 public:
  /// SUNDIALS treats a negative flag as unrecoverable and returns.
  static constexpr int kUnrecoverable = -1;

  /// Calls `callback` and returns the flag of the callback, or kUnrecoverable if the callback
  /// throws.
  template <class Callback>
  int invoke(const Callback& callback) noexcept {
    try {
      return callback();
    } catch (...) {
      // keep the first: later exceptions may be consequences of the first
      if (!thrown_) thrown_ = std::current_exception();
      return kUnrecoverable;
    }
  }

  /// Rethrows the first exception that was stored since the last call, if any.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace fpkcheck::fd_fpk
