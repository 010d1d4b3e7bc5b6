#include "cli/shutdown_after_signal.hpp"

#include <fmt/format.h>
#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <exception>
#include <mutex>
#include <vector>

#include "base/process/stop_request.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"

namespace fpkcheck::cli {
namespace {

constexpr int kStopSignals[] = {SIGINT, SIGTERM};

std::atomic<InterruptionPolicy> current_policy = InterruptionPolicy::abort;

extern "C" void handle_stop_signal(int signal) {
  const int error = errno;
  if (base::stop_requested()) {
    // When handle_stop_signal() returns and unblocks the signal, the default action of the signal
    // handles a second stop signal.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else {
    base::request_stop(signal);
    notify_watchdog();
  }
  errno = error;
}

using namespace std::chrono_literals;

// Times between a stop signal and the shutdown by the watchdog thread. After the delay kAbortDelay
// of 300 ms, 700 ms of one second remain for the shutdown hooks, even on busy processors. The
// longer delay kFinishDelay allows a simulation to complete its current round and to return its
// result. On a computer with few processors one round of a simulation, 2e7 events, takes longer
// than a second.
constexpr auto kAbortDelay = 300ms;
constexpr auto kFinishDelay = 4000ms;

constexpr const char* kNothingWritten = "nothing was written";

struct ShutdownState {
  std::mutex mutex;  // protects the other members of ShutdownState
  std::vector<const std::function<void()>*> hooks;
  std::string message = kNothingWritten;
  bool command_ended = false;
  std::condition_variable changed;
};

// The shutdown state is never destroyed, since threads may use the state while the process exits.
ShutdownState& shutdown_state() {
  static ShutdownState& state = *new ShutdownState;
  return state;
}

std::atomic<bool> watchdog_active = false, shutdown_claimed = false;
sem_t signal_received;

[[noreturn]] void wait_for_exit() {
  while (true) pause();
}

// Writes a line to standard error by write(2) instead of stdio, since a blocked thread may hold the
// stdio locks.
void write_line_without_stdio(const std::string& line) {
  const std::string text = (stderr_is_interactive() ? "\r\033[K" : "") + line + '\n';
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

// Ends the process after a stop signal, unless the running command has claimed the shutdown.
void shut_down_process() {
  if (shutdown_claimed) return;
  base::wait_for_exit_blockers();
  if (shutdown_claimed.exchange(true)) return;
  std::vector<const std::function<void()>*> hooks;
  std::unique_lock lock(shutdown_state().mutex);
  hooks.swap(shutdown_state().hooks);
  lock.unlock();
  std::ranges::reverse(hooks);
  for (const auto* hook : hooks) {
    try {
      (*hook)();
    } catch (const std::exception& error) {
      set_exit_message(fmt::format("{} ({})", kNothingWritten, error.what()));
    }
  }
  write_line_without_stdio("fpkcheck: " + exit_message());
  _exit(signal_exit_code(base::requested_stop_signal()));
}

void run_watchdog() {
  while (sem_wait(&signal_received) != 0) continue;
  ShutdownState& e = shutdown_state();
  std::unique_lock lock(e.mutex);
  const auto grace =
      interruption_policy() == InterruptionPolicy::finish_early ? kFinishDelay : kAbortDelay;
  if (e.changed.wait_for(lock, grace, [&] { return e.command_ended; })) return;
  lock.unlock();
  shut_down_process();
}

}  // namespace

SignalHandlerGuard::SignalHandlerGuard() {
  base::request_stop(0);
  current_policy = InterruptionPolicy::abort;
  for (const int signal : kStopSignals) {
    struct sigaction saved_action = {};
    sigaction(signal, nullptr, &saved_action);
    if (saved_action.sa_handler != SIG_DFL) continue;
    struct sigaction action = {};
    action.sa_handler = handle_stop_signal;
    // The flag SA_RESTART restarts interrupted system calls, e.g. reads from gnuplot.
    action.sa_flags = SA_RESTART;
    if (sigaction(signal, &action, nullptr) == 0) saved_actions_.push_back({signal, saved_action});
  }
}

SignalHandlerGuard::~SignalHandlerGuard() {
  for (const auto& [signal, action] : saved_actions_) sigaction(signal, &action, nullptr);
  base::request_stop(0);
}

void set_interruption_policy(InterruptionPolicy policy) { current_policy = policy; }

InterruptionPolicy interruption_policy() { return current_policy; }

void throw_if_interrupted() {
  if (base::stop_requested() && current_policy == InterruptionPolicy::abort)
    throw InterruptedBySignal();
}

ShutdownHook::ShutdownHook(std::function<void()> action) : action_(std::move(action)) {
  const std::lock_guard lock(shutdown_state().mutex);
  shutdown_state().hooks.push_back(&action_);
}

ShutdownHook::~ShutdownHook() {
  std::unique_lock lock(shutdown_state().mutex);
  if (std::erase(shutdown_state().hooks, &action_) > 0) return;
  lock.unlock();
  wait_for_exit();  // the watchdog runs the action, whose data must exist until the exit
}

OutputDirectory::OutputDirectory(const std::optional<std::string>& out)
    : hook_([this] { directory_ = {}; }) {
  if (!out) return;
  const base::ProcessExitBlocker in_hand;
  directory_ = results::prepare_output_directory(*out);
}

void set_exit_message(const std::string& message) {
  const std::lock_guard lock(shutdown_state().mutex);
  shutdown_state().message = message;
}

std::string exit_message() {
  const std::lock_guard lock(shutdown_state().mutex);
  return fmt::format("{}; {}",
                     base::requested_stop_signal() == SIGTERM ? "terminated" : "interrupted",
                     shutdown_state().message);
}

ShutdownWatchdog::ShutdownWatchdog() {
  shutdown_claimed = false;
  shutdown_state().command_ended = false;
  sem_init(&signal_received, 0, 0);
  watchdog_active = true;
  thread_ = std::thread(run_watchdog);
}

ShutdownWatchdog::~ShutdownWatchdog() {
  {
    const std::lock_guard lock(shutdown_state().mutex);
    shutdown_state().command_ended = true;
  }
  shutdown_state().changed.notify_all();
  watchdog_active = false;
  sem_post(&signal_received);
  thread_.join();
}

void notify_watchdog() {
  if (watchdog_active) sem_post(&signal_received);
}

void claim_shutdown_for_this_thread() {
  if (watchdog_active && shutdown_claimed.exchange(true)) wait_for_exit();
}

}  // namespace fpkcheck::cli
