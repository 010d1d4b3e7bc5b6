#pragma once

#include <exception>
#include <utility>

namespace fpkcheck::fd_fpk {

/// Captures an exception of a callback that SUNDIALS calls. Exceptions must not propagate through
/// the C frames of SUNDIALS: the callback returns a flag instead, and the caller of SUNDIALS
/// rethrows the exception.
class CapturedException {
 public:
  /// SUNDIALS treats a negative flag as unrecoverable and returns.
  static constexpr int kUnrecoverable = -1;

  /// Calls `callback` and returns its flag; kUnrecoverable when it throws.
  template <class Callback>
  int invoke(const Callback& callback) noexcept {
    try {
      return callback();
    } catch (...) {
      if (!thrown_) thrown_ = std::current_exception();  // later exceptions may be consequences
      return kUnrecoverable;
    }
  }

  /// Rethrows the first exception captured since the last call, if any.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace fpkcheck::fd_fpk
