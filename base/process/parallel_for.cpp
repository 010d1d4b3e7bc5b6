#include "base/process/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/process/processors.hpp"

namespace fpkcheck::base {

int number_of_threads(int requested) { return requested > 0 ? requested : available_processors(); }

void parallel_for(std::size_t count, int requested_threads,
                  const std::function<void(std::size_t)>& work) {
  const auto thread_count = static_cast<std::size_t>(number_of_threads(requested_threads));
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto call_remaining = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t w = 1; w < std::min(thread_count, count); ++w) {
      others.emplace_back(call_remaining);
    }
    call_remaining();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fpkcheck::base
