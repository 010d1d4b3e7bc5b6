#pragma once

/// The request to stop the program, set by a signal handler. Code of every directory may read the
/// request; only `cli` installs signal handlers.
namespace fpkcheck::base {

/// Number of the signal that requested the stop; 0 if no stop was requested.
int stop_signal();

inline bool stop_requested() { return stop_signal() != 0; }

/// Stores the number of the signal as a request to stop; the number 0 clears the request. The
/// function is async-signal-safe.
void request_stop(int signal);

}  // namespace fpkcheck::base
