#pragma once

#include <csignal>
#include <exception>
#include <vector>

namespace fpkcheck::cli {

/// Exception that is thrown after SIGINT (Ctrl-C) or SIGTERM. The message for the user is
/// exit_message() (shutdown.hpp).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Reaction of the program to the first SIGINT or SIGTERM.
enum class InterruptionPolicy {
  abort,        ///< throw_if_interrupted throws
  finish_early  ///< the solver polls base::stop_requested() and returns its result so far
};

/// Guard that installs signal handlers during its lifetime. The first SIGINT or SIGTERM sets the
/// stop request (base/process/stop_request.hpp); a second signal ends the program at once. Signals
/// that are ignored (nohup) stay ignored.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct SavedAction {
    int signal;
    struct sigaction action;
  };
  std::vector<SavedAction> saved_actions_;
};

/// Sets or returns the current reaction to signals. The default policy is `abort`.
void set_interruption_policy(InterruptionPolicy policy);
InterruptionPolicy interruption_policy();

/// Ends a computation after a signal. The progress functions of long computations call this
/// function.
/// @throws Interrupted after SIGINT or SIGTERM, unless the policy is finish_early
void throw_if_interrupted();

}  // namespace fpkcheck::cli
