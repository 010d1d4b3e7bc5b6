#pragma once

#include <csignal>
#include <exception>

namespace fpkcheck::cli {

/// Ctrl-C, while something was solved.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted; nothing was written"; }
};

/// While this lives, the first Ctrl-C is noted for throw_if_interrupted; a second one ends the
/// program. Leaves Ctrl-C alone where it is handled (mcs) or ignored (nohup) already.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct sigaction before_ = {};
  bool active_ = false;
};

/// To be called from the progress of what takes long.
/// @throws Interrupted after a Ctrl-C that a guard noted
void throw_if_interrupted();

}  // namespace fpkcheck::cli
