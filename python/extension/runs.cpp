#include "extension/runs.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "base/process/stop_request.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/case_results.hpp"
#include "report/write_report.hpp"
#include "results/output_directory.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::python {
namespace {

using namespace std::chrono_literals;

constexpr auto kPollInterval = 50ms;
constexpr auto kGracePeriod = 300ms;

struct RunCancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

/// A run in progress. The worker thread and the calling thread share the ownership of this object,
/// since either thread may end last.
class RunInProgress {
 public:
  explicit RunInProgress(RunRequest task) : task_(std::move(task)) {}

  void run() noexcept {
    try {
      solve_problems();
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    changed_.notify_all();
  }

  /// Waits for a limited time and returns whether the run has ended.
  template <class Duration>
  bool wait_for(Duration duration) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, duration, [this] { return has_ended_; });
  }
  bool has_ended() { return wait_for(0ms); }

  void cancel() { is_cancelled_ = true; }

  /// Returns the latest progress of the run; empty if the progress has not changed.
  std::optional<methods::RunProgress> progress_update() {
    const std::lock_guard lock(mutex_);
    return std::exchange(progress_update_, std::nullopt);
  }

  /// @pre has_ended()
  results::Run result() {
    assert(has_ended());
    if (failure_) std::rethrow_exception(failure_);
    return std::move(run_);
  }

 private:
  void solve_problems() {
    run_.program = results::current_program(task_.command);
    run_.cases = methods::compute_case_results(task_.problems, task_.methods,
                                               {.threads = task_.threads,
                                                .with_backward = task_.bounds,
                                                .progress =
                                                    [this](const methods::RunProgress& at) {
                                                      throw_if_cancelled();
                                                      const std::lock_guard lock(mutex_);
                                                      progress_update_ = at;
                                                    },
                                                .poll = [this] { throw_if_cancelled(); }});
  }

  void throw_if_cancelled() const {
    if (is_cancelled_) throw RunCancelled();
  }

  RunRequest task_;
  results::Run run_;
  std::exception_ptr failure_;
  std::atomic<bool> is_cancelled_ = false;
  std::mutex mutex_;  // protects all members below
  std::condition_variable changed_;
  bool has_ended_ = false;
  std::optional<methods::RunProgress> progress_update_;
};

struct AbandonedRun {
  std::shared_ptr<RunInProgress> work;
  std::thread thread;
};

// The list of abandoned threads, which is never destroyed. Abandoned threads may still run at the
// end of the process.
struct AbandonedRuns {
  std::mutex mutex;
  std::vector<AbandonedRun> all;
};
AbandonedRuns& abandoned_runs() {
  static AbandonedRuns& one = *new AbandonedRuns;
  return one;
}

void join_ended_threads() {
  const std::lock_guard lock(abandoned_runs().mutex);
  std::erase_if(abandoned_runs().all, [](AbandonedRun& one) {
    if (!one.work->has_ended()) return false;
    one.thread.join();
    return true;
  });
}

bool has_abandoned_runs() {
  join_ended_threads();
  const std::lock_guard lock(abandoned_runs().mutex);
  return !abandoned_runs().all.empty();
}

}  // namespace

results::Run solve(RunRequest task, const std::function<void(const methods::RunProgress*)>& poll) {
  join_ended_threads();
  const auto work = std::make_shared<RunInProgress>(std::move(task));
  std::thread thread([work] { work->run(); });
  try {
    while (!work->wait_for(kPollInterval)) {
      const auto progress_update = work->progress_update();
      poll(progress_update ? &*progress_update : nullptr);
    }
  } catch (...) {
    work->cancel();
    if (work->wait_for(kGracePeriod)) {
      thread.join();
    } else {
      const std::lock_guard lock(abandoned_runs().mutex);
      abandoned_runs().all.push_back({work, std::move(thread)});
    }
    throw;
  }
  thread.join();
  return work->result();
}

void prepare_for_exit() {
  if (!has_abandoned_runs()) return;
  // The function exit() calls exit handlers and destructors of static objects in reverse order of
  // registration. This handler is registered last and therefore runs before the destructors.
  on_exit(
      [](int status, void*) {
        if (!has_abandoned_runs()) return;
        std::fflush(nullptr);
        _exit(status);
      },
      nullptr);
}

namespace {

// Returns the mutex for reading and writing files, since netCDF is not thread-safe.
std::mutex& files_mutex() {
  static std::mutex& one = *new std::mutex;
  return one;
}

// Disables the error messages of HDF5 in the current thread. HDF5 prints a message for every
// missing attribute, and netCDF disables these messages only in the first thread that uses netCDF.
void silence_hdf5_in_this_thread() {
  using SetAuto = int (*)(std::int64_t, void*, void*);
  const auto set_auto = reinterpret_cast<SetAuto>(dlsym(RTLD_DEFAULT, "H5Eset_auto2"));
  if (set_auto != nullptr) set_auto(0, nullptr, nullptr);
}

std::vector<std::string> write_files_locked(const std::filesystem::path& directory,
                                            const results::Run& run) {
  const std::lock_guard lock(files_mutex());
  silence_hdf5_in_this_thread();
  const base::ProcessExitBlocker write_guard;
  const auto directory_lock = results::prepare_output_directory(directory);
  return report::write_report(directory, run);
}

}  // namespace

std::vector<std::string> save(const std::filesystem::path& directory, const results::Run& run,
                              const std::function<void()>& poll) {
  auto warnings =
      std::async(std::launch::async, [&] { return write_files_locked(directory, run); });
  try {
    while (warnings.wait_for(kPollInterval) != std::future_status::ready) poll();
  } catch (...) {
    base::request_stop(SIGINT);
    warnings.wait();
    base::request_stop(0);
    throw;
  }
  return warnings.get();
}

results::Run load(const std::filesystem::path& directory) {
  const std::lock_guard lock(files_mutex());
  silence_hdf5_in_this_thread();
  auto run = results::load_run(directory);
  methods::builtin_registry().set_missing_identity_fields_of_run(run);
  return run;
}

}  // namespace fpkcheck::python
