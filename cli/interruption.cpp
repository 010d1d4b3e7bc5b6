#include "cli/interruption.hpp"

#include <atomic>
#include <cerrno>

#include "base/process/stop_request.hpp"
#include "cli/shutdown.hpp"

namespace fpkcheck::cli {
namespace {

constexpr int kStopSignals[] = {SIGINT, SIGTERM};

std::atomic<InterruptionPolicy> current_policy = InterruptionPolicy::abort;

extern "C" void handle_stop_signal(int signal) {
  const int error = errno;
  if (base::stop_requested()) {
    // The second signal has the default action. The signal is blocked until this handler returns.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else {
    base::request_stop(signal);
    notify_watchdog();
  }
  errno = error;
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  base::request_stop(0);
  current_policy = InterruptionPolicy::abort;
  for (const int signal : kStopSignals) {
    struct sigaction saved_action = {};
    sigaction(signal, nullptr, &saved_action);
    if (saved_action.sa_handler != SIG_DFL) continue;
    struct sigaction action = {};
    action.sa_handler = handle_stop_signal;
    // Restart interrupted system calls, e.g. reads from gnuplot.
    action.sa_flags = SA_RESTART;
    if (sigaction(signal, &action, nullptr) == 0) saved_actions_.push_back({signal, saved_action});
  }
}

InterruptionGuard::~InterruptionGuard() {
  for (const auto& [signal, action] : saved_actions_) sigaction(signal, &action, nullptr);
  base::request_stop(0);
}

void set_interruption_policy(InterruptionPolicy policy) { current_policy = policy; }

InterruptionPolicy interruption_policy() { return current_policy; }

void throw_if_interrupted() {
  if (base::stop_requested() && current_policy == InterruptionPolicy::abort) throw Interrupted();
}

}  // namespace fpkcheck::cli
