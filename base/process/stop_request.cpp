#include "base/process/stop_request.hpp"

#include <atomic>

namespace fpkcheck::base {
namespace {

std::atomic<int> stopping_signal = 0;
// Signal handlers may use lock-free atomics only.
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

int stop_signal() { return stopping_signal.load(std::memory_order_relaxed); }

void request_stop(int signal) { stopping_signal.store(signal, std::memory_order_relaxed); }

}  // namespace fpkcheck::base
