#include "base/process/parallel_for.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace fpkcheck::base {

int resolve_thread_count(int requested) {
  return requested > 0 ? requested : available_processors();
}

void parallel_for(std::size_t count, int requested_threads,
                  const std::function<void(std::size_t)>& work) {
  const auto thread_count = static_cast<std::size_t>(resolve_thread_count(requested_threads));
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

namespace {

// The processor set is allocated dynamically, since a fixed cpu_set_t holds only 1024 processors
// and sched_getaffinity fails on larger machines.
int affinity_processor_count() {
  constexpr int kMostProcessors = 1 << 16;
  for (int size = CPU_SETSIZE; size <= kMostProcessors; size *= 2) {
    const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> set(
        CPU_ALLOC(size), [](cpu_set_t* allocated) { CPU_FREE(allocated); });
    if (!set) break;
    const std::size_t bytes = CPU_ALLOC_SIZE(size);
    if (sched_getaffinity(0, bytes, set.get()) == 0) return CPU_COUNT_S(bytes, set.get());
  }
  return static_cast<int>(std::thread::hardware_concurrency());
}

// OMP_NUM_THREADS may be a list with one number of threads for each level of nested parallelism, of
// which only the first number is used.
int limit_from_environment(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  if (text == nullptr) return otherwise;
  int number = 0;
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), number);
  const bool whole = error == std::errc() && (*end == '\0' || *end == ',' || *end == ' ');
  return whole && number > 0 ? std::min(number, otherwise) : otherwise;
}

}  // namespace

int available_processors() {
  const int affinity_count = std::max(1, affinity_processor_count());
  return limit_from_environment("SLURM_CPUS_PER_TASK",
                                limit_from_environment("OMP_NUM_THREADS", affinity_count));
}

}  // namespace fpkcheck::base
