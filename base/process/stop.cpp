#include "base/process/stop.hpp"

#include <atomic>

namespace fpkcheck::base {
namespace {

std::atomic<int> stopping_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // required in a signal handler

}  // namespace

int stop_signal() { return stopping_signal.load(std::memory_order_relaxed); }

void request_stop(int signal) { stopping_signal.store(signal, std::memory_order_relaxed); }

}  // namespace fpkcheck::base
