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

struct ComputationCancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

/// A computation in progress. The worker thread and the calling thread share the ownership of this
/// object, since either thread may end last.
class ComputationInProgress {
 public:
  explicit ComputationInProgress(std::function<void(const WorkerCallbacks&)> compute)
      : compute_(std::move(compute)) {}

  void run() noexcept {
    try {
      compute_({.progress =
                    [this](const methods::RunProgress& at) {
                      throw_if_cancelled();
                      const std::lock_guard lock(mutex_);
                      progress_update_ = at;
                    },
                .throw_if_cancelled = [this] { throw_if_cancelled(); }});
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    changed_.notify_all();
  }

  /// Waits for a limited time and returns whether the computation has ended.
  template <class Duration>
  bool wait_for(Duration duration) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, duration, [this] { return has_ended_; });
  }
  bool has_ended() { return wait_for(0ms); }

  void cancel() { is_cancelled_ = true; }

  /// Returns the latest progress; empty if the progress has not changed.
  std::optional<methods::RunProgress> progress_update() {
    const std::lock_guard lock(mutex_);
    return std::exchange(progress_update_, std::nullopt);
  }

  /// @throws the exception with which the computation ended, if any
  /// @pre has_ended()
  void rethrow_failure() {
    assert(has_ended());
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void throw_if_cancelled() const {
    if (is_cancelled_) throw ComputationCancelled();
  }

  std::function<void(const WorkerCallbacks&)> compute_;
  std::exception_ptr failure_;
  std::atomic<bool> is_cancelled_ = false;
  std::mutex mutex_;  // protects all members below
  std::condition_variable changed_;
  bool has_ended_ = false;
  std::optional<methods::RunProgress> progress_update_;
};

struct AbandonedComputation {
  std::shared_ptr<ComputationInProgress> work;
  std::thread thread;
};

// The list of abandoned threads, which is never destroyed. Abandoned threads may still run at the
// end of the process.
struct AbandonedComputations {
  std::mutex mutex;
  std::vector<AbandonedComputation> all;
};
AbandonedComputations& abandoned_computations() {
  static AbandonedComputations& one = *new AbandonedComputations;
  return one;
}

void join_ended_threads() {
  const std::lock_guard lock(abandoned_computations().mutex);
  std::erase_if(abandoned_computations().all, [](AbandonedComputation& one) {
    if (!one.work->has_ended()) return false;
    one.thread.join();
    return true;
  });
}

bool has_abandoned_computations() {
  join_ended_threads();
  const std::lock_guard lock(abandoned_computations().mutex);
  return !abandoned_computations().all.empty();
}

}  // namespace

void compute_in_worker_thread(std::function<void(const WorkerCallbacks&)> compute,
                              const ProgressPoll& poll) {
  join_ended_threads();
  const auto work = std::make_shared<ComputationInProgress>(std::move(compute));
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
      const std::lock_guard lock(abandoned_computations().mutex);
      abandoned_computations().all.push_back({work, std::move(thread)});
    }
    throw;
  }
  thread.join();
  work->rethrow_failure();
}

results::Run solve(RunRequest request, const ProgressPoll& poll) {
  const auto run = std::make_shared<results::Run>();
  compute_in_worker_thread(
      [request = std::move(request), run](const WorkerCallbacks& callbacks) {
        run->program = results::current_program(request.command);
        run->cases = methods::compute_case_results(request.problems, request.methods,
                                                   {.threads = request.threads,
                                                    .with_backward = request.bounds,
                                                    .progress = callbacks.progress,
                                                    .poll = callbacks.throw_if_cancelled});
      },
      poll);
  return std::move(*run);
}

void prepare_for_exit() {
  if (!has_abandoned_computations()) return;
  // The function exit() calls exit handlers and destructors of static objects in reverse order of
  // registration. This handler is registered last and therefore runs before the destructors.
  on_exit(
      [](int status, void*) {
        if (!has_abandoned_computations()) return;
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
