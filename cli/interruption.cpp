#include "cli/interruption.hpp"

namespace fpkcheck::cli {
namespace {

volatile std::sig_atomic_t noted = 0;
OnInterruption what_to_do = OnInterruption::give_up;

// All that is allowed in a handler.
extern "C" void note_first_interruption(int) { noted = 1; }

}  // namespace

InterruptionGuard::InterruptionGuard(OnInterruption what) {
  noted = 0;
  what_to_do = what;
  sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler != SIG_DFL) return;
  struct sigaction action = {};
  action.sa_handler = note_first_interruption;
  // The default comes back for the second; system calls, as reading from gnuplot, are not broken.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  active_ = sigaction(SIGINT, &action, nullptr) == 0;
}

InterruptionGuard::~InterruptionGuard() {
  if (active_) sigaction(SIGINT, &before_, nullptr);
}

bool interrupted() { return noted != 0; }

void throw_if_interrupted() {
  if (interrupted() && what_to_do == OnInterruption::give_up) throw Interrupted();
}

}  // namespace fpkcheck::cli
