#pragma once

#include <exception>
#include <utility>

namespace fpkcheck::fd_fpk {

/// Carries what a callback throws past the C frames of SUNDIALS that called it, which no exception
/// may cross: the callback returns a flag instead, and whoever called SUNDIALS throws on the other
/// side.
class CarriedException {
 public:
  /// For SUNDIALS a negative flag is beyond repair: it gives up and returns.
  static constexpr int kUnrecoverable = -1;

  /// What `callback` returns, a flag; kUnrecoverable when it throws.
  template <class Callback>
  int flag_of(const Callback& callback) noexcept {
    try {
      return callback();
    } catch (...) {
      if (!thrown_) thrown_ = std::current_exception();  // what comes after it may follow from it
      return kUnrecoverable;
    }
  }

  /// Throws what was thrown first since the last call, if anything was.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace fpkcheck::fd_fpk
