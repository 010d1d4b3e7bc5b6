#pragma once

#include <csignal>
#include <exception>

namespace fpkcheck::cli {

/// Ctrl-C, while something was solved.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted; nothing was written"; }
};

/// What the first Ctrl-C does.
enum class OnInterruption {
  give_up,      ///< throw_if_interrupted throws
  finish_early  ///< what is solved asks interrupted() and ends with what it has
};

/// While this lives, the first Ctrl-C is noted; a second one ends the program. Leaves Ctrl-C alone
/// where it is ignored (nohup).
class InterruptionGuard {
 public:
  explicit InterruptionGuard(OnInterruption what = OnInterruption::give_up);
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

 private:
  struct sigaction before_ = {};
  bool active_ = false;
};

/// True after a Ctrl-C that a guard noted.
bool interrupted();

/// To be called from the progress of what takes long.
/// @throws Interrupted after a Ctrl-C that a guard noted, unless it is to finish early
void throw_if_interrupted();

}  // namespace fpkcheck::cli
