#pragma once

/// What the surroundings ask of the process: to stop, and to use no more processors than are its
/// own. Every room may look; only cli listens to signals.
namespace fpkcheck::base {

/// The signal that asked the program to stop; 0 as long as none did.
int stop_signal();

inline bool stop_requested() { return stop_signal() != 0; }

/// Notes the signal; 0 forgets. May be called in a handler of signals.
void request_stop(int signal);

}  // namespace fpkcheck::base
