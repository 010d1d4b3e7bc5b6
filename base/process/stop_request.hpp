#pragma once

/// Functions that store a stop request of a signal handler, and delay the exit of the process while
/// files are written. Only the directory `cli` installs signal handlers.
namespace fpkcheck::base {

/// Returns the number of the signal that requested a stop; 0 if no stop was requested.
int requested_stop_signal();

inline bool stop_requested() { return requested_stop_signal() != 0; }

/// Stores the number of a signal as a request to stop the program; the number 0 clears the request.
/// The function is async-signal-safe.
void request_stop(int signal);

/// Guard object that delays the exit of the process while the thread of the guard writes files.
/// While an ProcessExitBlocker exists, no other thread ends the process. Guards of one thread may
/// be nested, and several threads may hold guards at the same time.
class ProcessExitBlocker {
 public:
  ProcessExitBlocker();
  ~ProcessExitBlocker();
  ProcessExitBlocker(const ProcessExitBlocker&) = delete;
  ProcessExitBlocker& operator=(const ProcessExitBlocker&) = delete;
};

/// Waits until no ProcessExitBlocker exists. Afterwards, the constructor of ProcessExitBlocker
/// blocks every thread except the calling thread. The thread that ends the process calls this
/// function first.
void wait_for_exit_blockers();

}  // namespace fpkcheck::base
