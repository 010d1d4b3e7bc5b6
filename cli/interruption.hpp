#pragma once

#include <csignal>
#include <exception>
#include <vector>

namespace fpkcheck::cli {

/// Ctrl-C or SIGTERM, while something was solved. What the user is told says stop_notice()
/// (ending.hpp).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// What the first Ctrl-C or SIGTERM does.
enum class OnInterruption {
  give_up,      ///< throw_if_interrupted throws
  finish_early  ///< what is solved asks base::stop_requested() and ends with what it has
};

/// While this lives, the first Ctrl-C or SIGTERM is noted (base/process/stop.hpp); a second one ends the
/// program at once. Leaves each alone where it is ignored (nohup).
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct Before {
    int signal;
    struct sigaction action;
  };
  std::vector<Before> before_;
};

/// give_up until told otherwise.
void on_interruption(OnInterruption what);
OnInterruption on_interruption();

/// To be called from the progress of what takes long.
/// @throws Interrupted after a Ctrl-C or SIGTERM that a guard noted, unless it is to finish early
void throw_if_interrupted();

}  // namespace fpkcheck::cli
