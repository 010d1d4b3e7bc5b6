#include "mcs/simulation/parallel_for.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/process/processors.hpp"

namespace fpkcheck::mcs {

int number_of_threads(const std::optional<int>& requested) {
  return requested.value_or(base::available_processors());
}

void parallel_for(int threads, std::size_t shares, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // protects `failure`
  std::exception_ptr failure;
  const auto take_shares = [&] {
    for (std::size_t share = next++; share < shares; share = next++) {
      try {
        work(share);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = shares;  // no thread starts another task
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int t = 1; t < threads; ++t) others.emplace_back(take_shares);
    take_shares();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fpkcheck::mcs
