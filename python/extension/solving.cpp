#include "extension/solving.hpp"

#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "methods/complete_run.hpp"

namespace fpkcheck::python {
namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenLooks = 50ms;
constexpr auto kToEndByItself = 300ms;

struct GivenUp : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

/// A run in progress. The worker and the calling thread share ownership, since either may end last.
class Work {
 public:
  explicit Work(Task task) : task_(std::move(task)) {}

  /// The function of the worker thread.
  void run() noexcept {
    try {
      solve_all();
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  /// Waits for the end of the run.
  /// @return whether the run has ended
  template <class Duration>
  bool wait_for(Duration duration) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, duration, [this] { return ended_; });
  }
  bool has_ended() { return wait_for(0ms); }

  void give_up() { given_up_ = true; }

  /// The latest progress since the previous call, if any.
  std::optional<methods::RunProgress> news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, std::nullopt);
  }

  /// @pre has_ended()
  results::Run result() {
    if (failure_) std::rethrow_exception(failure_);
    return std::move(run_);
  }

 private:
  void solve_all() {
    run_.program = results::this_program(task_.command);
    run_.cases = methods::complete_run(task_.problems, task_.methods,
                                       {.threads = task_.threads,
                                        .with_dual = task_.bounds,
                                        .progress =
                                            [this](const methods::RunProgress& at) {
                                              throw_if_given_up();
                                              const std::lock_guard lock(mutex_);
                                              news_ = at;
                                            },
                                        .look = [this] { throw_if_given_up(); }});
  }

  void throw_if_given_up() const {
    if (given_up_) throw GivenUp();
  }

  Task task_;
  results::Run run_;
  std::exception_ptr failure_;
  std::atomic<bool> given_up_ = false;
  std::mutex mutex_;  // guards the members below
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<methods::RunProgress> news_;
};

struct LeftBehind {
  std::shared_ptr<Work> work;
  std::thread thread;
};

// Never destroyed, since its threads may still run at the end of the process.
struct Abandoned {
  std::mutex mutex;
  std::vector<LeftBehind> all;
};
Abandoned& abandoned() {
  static Abandoned& one = *new Abandoned;
  return one;
}

void forget_ended() {
  const std::lock_guard lock(abandoned().mutex);
  std::erase_if(abandoned().all, [](LeftBehind& one) {
    if (!one.work->has_ended()) return false;
    one.thread.join();
    return true;
  });
}

bool any_abandoned() {
  forget_ended();
  const std::lock_guard lock(abandoned().mutex);
  return !abandoned().all.empty();
}

}  // namespace

results::Run solve(Task task, const std::function<void(const methods::RunProgress*)>& look) {
  forget_ended();
  const auto work = std::make_shared<Work>(std::move(task));
  std::thread thread([work] { work->run(); });
  try {
    while (!work->wait_for(kBetweenLooks)) {
      const auto news = work->news();
      look(news ? &*news : nullptr);
    }
  } catch (...) {
    work->give_up();
    if (work->wait_for(kToEndByItself)) {
      thread.join();
    } else {
      const std::lock_guard lock(abandoned().mutex);
      abandoned().all.push_back({work, std::move(thread)});
    }
    throw;
  }
  thread.join();
  return work->result();
}

void prepare_for_exit() {
  if (!any_abandoned()) return;
  // Handlers run in reverse order of registration: this handler runs before any destructor.
  on_exit(
      [](int status, void*) {
        if (!any_abandoned()) return;
        std::fflush(nullptr);
        _exit(status);
      },
      nullptr);
}

}  // namespace fpkcheck::python
