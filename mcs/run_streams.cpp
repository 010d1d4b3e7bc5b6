#include "mcs/run_streams.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace fpkcheck::mcs {

std::vector<StreamRecord> run_streams(const problem::Problem& problem, const Plan& plan,
                                      const std::function<void(double)>& progress) {
  std::vector<std::optional<StreamRecord>> slots(plan.streams);
  std::atomic<int> next = 0;
  std::mutex mutex;  // guards the two below
  int done = 0;
  std::exception_ptr failure;

  const auto stop = [&] {  // with the lock held
    if (!failure) failure = std::current_exception();
    next = plan.streams;  // nobody begins another stream
  };
  const auto work = [&] {
    for (int s = next++; s < plan.streams; s = next++) {
      try {
        slots[s] = run_stream(problem, plan, static_cast<std::uint32_t>(s));
        const std::lock_guard lock(mutex);
        ++done;
        if (!progress || failure) continue;
        // Caught here, with the lock held: no other thread reports after a report has thrown.
        try {
          progress(static_cast<double>(done) / plan.streams);
        } catch (...) {
          stop();
        }
      } catch (...) {
        const std::lock_guard lock(mutex);
        stop();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int t = 1; t < plan.threads; ++t) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);

  std::vector<StreamRecord> records;
  for (auto& slot : slots) records.push_back(std::move(*slot));
  return records;
}

}  // namespace fpkcheck::mcs
