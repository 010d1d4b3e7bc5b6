#pragma once

/// Functions that store a stop request of a signal handler, and delay the exit of the process while
/// files are written. Only the directory `cli` installs signal handlers.
namespace fpkcheck::base {

/// Returns the number of the signal that requested a stop; 0 if no stop was requested.
int requested_stop_signal();

inline bool stop_requested() { return requested_stop_signal() != 0; }

/// Stores the number of a signal as a request to stop the program; the number 0 clears the request.
/// The function request_stop() is async-signal-safe.
void request_stop(int signal);

/// Guard object that delays the exit of the process while a thread writes files. While a
/// ProcessExitBlocker exists, no other thread ends the process. A thread may hold nested
/// ProcessExitBlocker objects, and several threads may hold such objects at the same time.
class ProcessExitBlocker {
 public:
  ProcessExitBlocker();
  ~ProcessExitBlocker();
  ProcessExitBlocker(const ProcessExitBlocker&) = delete;
  ProcessExitBlocker& operator=(const ProcessExitBlocker&) = delete;
};

/// Waits until no ProcessExitBlocker exists. After wait_for_exit_blockers() has returned, the
/// constructor of ProcessExitBlocker blocks every thread except the thread that called
/// wait_for_exit_blockers(). A thread calls wait_for_exit_blockers() before it ends the process.
void wait_for_exit_blockers();

}  // namespace fpkcheck::base
