#pragma once

/// The request to stop, set by a signal. Every room may read it; only cli installs signal handlers.
namespace fpkcheck::base {

/// Number of the signal that requested the stop; 0 when there was none.
int stop_signal();

inline bool stop_requested() { return stop_signal() != 0; }

/// Stores the signal number; 0 clears the request. Async-signal-safe.
void request_stop(int signal);

}  // namespace fpkcheck::base
