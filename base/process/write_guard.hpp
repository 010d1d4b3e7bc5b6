#pragma once

namespace fpkcheck::base {

/// While a guard exists, its thread has incomplete files and no other thread ends the process.
/// Guards nest, and several threads may hold one at the same time.
class WriteGuard {
 public:
  WriteGuard();
  ~WriteGuard();
  WriteGuard(const WriteGuard&) = delete;
  WriteGuard& operator=(const WriteGuard&) = delete;
};

/// Waits until no guard exists, then allows guards to the calling thread only. Call before ending
/// the process from a thread other than the working one. Other threads that construct a guard later
/// block until the process exits.
void reserve_writes_for_this_thread();

}  // namespace fpkcheck::base
