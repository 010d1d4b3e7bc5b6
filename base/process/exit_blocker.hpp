#pragma once

namespace fpkcheck::base {

/// Delays the exit of the process while a thread writes files. While a guard exists, the thread
/// that constructed the guard may have incomplete files, and no other thread ends the process.
/// Guards of one thread may be nested, and several threads may hold guards at the same time.
class ExitBlocker {
 public:
  ExitBlocker();
  ~ExitBlocker();
  ExitBlocker(const ExitBlocker&) = delete;
  ExitBlocker& operator=(const ExitBlocker&) = delete;
};

/// Waits until no guard exists; afterwards only the calling thread can construct guards. A thread
/// other than the one that writes files calls this function before the thread ends the process. Any
/// other thread that constructs a guard later is blocked until the process exits.
void stop_writes_of_other_threads();

}  // namespace fpkcheck::base
