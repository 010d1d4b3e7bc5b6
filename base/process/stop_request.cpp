#include "base/process/stop_request.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace fpkcheck::base {
namespace {

std::atomic<int> stopping_signal = 0;
// Signal handlers may use only lock-free atomic variables.
static_assert(std::atomic<int>::is_always_lock_free);

// The object ProcessExitBlockerState is never destroyed, since a thread may still wait for its
// condition variable while the process exits.
struct ProcessExitBlockerState {
  std::mutex mutex;
  std::condition_variable changed;
  int guard_count = 0;
  std::thread::id owner{};  // the default thread id denotes no thread
};

ProcessExitBlockerState& guard_state() {
  static ProcessExitBlockerState& state = *new ProcessExitBlockerState;
  return state;
}

}  // namespace

int requested_stop_signal() { return stopping_signal.load(std::memory_order_relaxed); }

void request_stop(int signal) { stopping_signal.store(signal, std::memory_order_relaxed); }

ProcessExitBlocker::ProcessExitBlocker() {
  ProcessExitBlockerState& d = guard_state();
  std::unique_lock lock(d.mutex);
  d.changed.wait(
      lock, [&] { return d.owner == std::thread::id() || d.owner == std::this_thread::get_id(); });
  ++d.guard_count;
}

ProcessExitBlocker::~ProcessExitBlocker() {
  ProcessExitBlockerState& d = guard_state();
  const std::lock_guard lock(d.mutex);
  --d.guard_count;
  d.changed.notify_all();
}

void wait_for_exit_blockers() {
  ProcessExitBlockerState& d = guard_state();
  std::unique_lock lock(d.mutex);
  d.changed.wait(lock, [&] { return d.guard_count == 0; });
  d.owner = std::this_thread::get_id();
}

}  // namespace fpkcheck::base
