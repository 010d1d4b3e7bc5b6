#include "cli/interruption.hpp"

#include <atomic>
#include <cerrno>

#include "base/process/stop.hpp"
#include "cli/ending.hpp"

namespace fpkcheck::cli {
namespace {

constexpr int kStopping[] = {SIGINT, SIGTERM};

std::atomic<OnInterruption> what_to_do = OnInterruption::give_up;

extern "C" void note_interruption(int signal) {
  const int error = errno;
  if (base::stop_requested()) {
    // The second signal has the default action. The signal is blocked until this handler returns.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else {
    base::request_stop(signal);
    wake_deadline();
  }
  errno = error;
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  base::request_stop(0);
  what_to_do = OnInterruption::give_up;
  for (const int signal : kStopping) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_DFL) continue;
    struct sigaction action = {};
    action.sa_handler = note_interruption;
    // Restart interrupted system calls, e.g. reads from gnuplot.
    action.sa_flags = SA_RESTART;
    if (sigaction(signal, &action, nullptr) == 0) before_.push_back({signal, before});
  }
}

InterruptionGuard::~InterruptionGuard() {
  for (const auto& [signal, action] : before_) sigaction(signal, &action, nullptr);
  base::request_stop(0);
}

void on_interruption(OnInterruption what) { what_to_do = what; }

OnInterruption on_interruption() { return what_to_do; }

void throw_if_interrupted() {
  if (base::stop_requested() && what_to_do == OnInterruption::give_up) throw Interrupted();
}

}  // namespace fpkcheck::cli
