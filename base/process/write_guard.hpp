#pragma once

namespace fpkcheck::base {

/// Delays the exit of the process while a thread writes files. While a guard exists, the thread
/// that constructed the guard may have incomplete files, and no other thread ends the process.
/// Guards of one thread may be nested, and several threads may hold guards at the same time.
class WriteGuard {
 public:
  WriteGuard();
  ~WriteGuard();
  WriteGuard(const WriteGuard&) = delete;
  WriteGuard& operator=(const WriteGuard&) = delete;
};

/// Waits until no guard exists; afterwards only the calling thread can construct guards. A thread
/// other than the one that writes files calls this function before the thread ends the process. Any
/// other thread that constructs a guard later is blocked until the process exits.
void reserve_writes_for_this_thread();

}  // namespace fpkcheck::base
