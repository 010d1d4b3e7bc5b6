#include "base/process/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <thread>

namespace fpkcheck::base {
namespace {

// The set is allocated dynamically: cpu_set_t has a fixed size of 1024 processors, with which
// sched_getaffinity fails on machines with more processors.
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

// OMP_NUM_THREADS may be a list with one number for each level of nested parallelism; the first
// number is used.
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
