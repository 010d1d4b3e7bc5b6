#pragma once

/// The end of the program: the request to stop, set by a signal handler, and the delay of the exit
/// while files are written. Code of every directory may read the request; only `cli` installs signal
/// handlers.
namespace fpkcheck::base {

/// Number of the signal that requested the stop; 0 if no stop was requested.
int stop_signal();

inline bool stop_requested() { return stop_signal() != 0; }

/// Stores the number of the signal as a request to stop; the number 0 clears the request. The
/// function is async-signal-safe.
void request_stop(int signal);

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
