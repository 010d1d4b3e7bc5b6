#include "workflows/sweep/execution/solve_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/parse_number.hpp"
#include "workflows/sweep/result/sweep_json.hpp"

namespace fpkcheck::sweep {
namespace {

/// Waits between two polls for MPI messages, since polling takes processor time from the solver
/// threads. The waiting time delays no solver thread, since each MPI rank has one point in reserve.
class PollingBackoff {
 public:
  void wait() {
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, kLongest);
  }
  void reset() { next_ = kShortest; }

 private:
  static constexpr std::chrono::microseconds kShortest{100}, kLongest{20000};
  std::chrono::microseconds next_ = kShortest;
};

// The first letter of a worker's message to the coordinator is the message type. The coordinator
// replies to each request and to each result with the number of the worker's next sweep point, or
// with kNoPointsLeft.
constexpr char kRequest = 'w';   // request for a point
constexpr char kSolved = 's';    // result of a point, and next request
constexpr char kFailed = 'f';    // text of an exception; final message of the worker
constexpr char kFinished = 'b';  // final message of a worker without an exception
constexpr const char* kNoPointsLeft = "none";

/// Solver threads of a rank. While the solver threads run, the calling thread exchanges messages
/// with the other MPI ranks.
class BackgroundSolver {
 public:
  BackgroundSolver(const SweepPlan& plan, SweepPointSource& points, int threads)
      : points_(points), solving_(std::async(std::launch::async, [&plan, &points, threads] {
          solve_remaining_sweep_points(plan, points, threads);
        })) {}
  // The destructor of solving_ joins the solver threads.
  ~BackgroundSolver() { points_.stop_assigning_points(); }
  BackgroundSolver(const BackgroundSolver&) = delete;
  BackgroundSolver& operator=(const BackgroundSolver&) = delete;

  bool is_running() const {
    return solving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }
  /// Joins the solver threads, and rethrows the first exception of a solver thread.
  void join() { solving_.get(); }

 private:
  SweepPointSource& points_;
  std::future<void> solving_;
};

/// Point source of a worker rank: the points that the coordinator assigned to the worker, and the
/// results that the worker has not yet sent to the coordinator.
class AssignedPoints final : public SweepPointSource {
 public:
  AssignedPoints(const SweepPlan& plan, std::filesystem::path directory)
      : plan_(plan), directory_(std::move(directory)) {}

  std::optional<std::size_t> take_next_sweep_point() override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
    if (closed_ || base::stop_requested()) return std::nullopt;
    const std::size_t point = waiting_.front();
    waiting_.pop_front();
    return point;
  }
  void store_solved_point(SolvedSweepPoint&& solved) override {
    write_marginals(plan_, directory_, solved);
    std::string text = kSolved + sweep_journal_line(solved.result);
    const std::lock_guard lock(mutex_);
    results_.push_back(std::move(text));
  }
  void stop_assigning_points() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  void add(std::size_t point) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(point);
    changed_.notify_one();
  }
  /// Removes and returns the messages with results that were not sent to the coordinator.
  std::vector<std::string> take_result_messages() {
    const std::lock_guard lock(mutex_);
    return std::exchange(results_, {});
  }

 private:
  const SweepPlan& plan_;
  std::filesystem::path directory_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> waiting_;
  std::vector<std::string> results_;
  bool closed_ = false;
};

// Replies to messages until each worker has sent its final message and the solver threads of this
// rank have ended.
// @param points source of points; null if no point can be assigned
// @param solver solver threads of this rank; null without solver threads
// @return first failure of a worker or of the journal; null without a failure
std::exception_ptr serve_workers(base::Communicator& ranks, SweepPointSource* points,
                                 const BackgroundSolver* solver) {
  std::exception_ptr failure;
  const auto end_after = [&](const std::exception_ptr& why) {
    if (!failure) failure = why;
    if (points != nullptr) points->stop_assigning_points();
  };
  PollingBackoff backoff;
  for (int workers = ranks.process_count() - 1;
       workers > 0 || (solver != nullptr && solver->is_running());) {
    const auto message = ranks.receive();
    if (!message) {
      backoff.wait();
      continue;
    }
    backoff.reset();
    const char type = message->text.at(0);
    const std::string content = message->text.substr(1);
    if (type == kFailed) {
      end_after(std::make_exception_ptr(
          std::runtime_error(fmt::format("rank {}: {}", message->from, content))));
    }
    if (type == kFailed || type == kFinished) {
      --workers;
      continue;
    }
    std::optional<std::size_t> next;
    if (points != nullptr) {
      try {
        if (type == kSolved)
          points->store_solved_point({point_result_from_json(results::Json::parse(content)), {}});
      } catch (...) {
        end_after(std::current_exception());
      }
      next = points->take_next_sweep_point();
    }
    ranks.send(message->from, next ? std::to_string(*next) : kNoPointsLeft);
  }
  return failure;
}

void run_coordinator(const SweepPlan& plan, JournaledPointQueue& points, base::Communicator& ranks,
                     int threads) {
  BackgroundSolver solver(plan, points, threads);
  const auto failure = serve_workers(ranks, &points, &solver);
  solver.join();
  if (failure) std::rethrow_exception(failure);
}

void run_worker(const SweepPlan& plan, const std::filesystem::path& directory,
                base::Communicator& ranks, int threads) {
  constexpr int kCoordinator = 0;
  AssignedPoints points(plan, directory);
  BackgroundSolver solver(plan, points, threads);
  // The number of open requests of a worker exceeds the number of its solver threads by one. One
  // sweep point is in reserve, so that no solver thread waits for a reply of the coordinator.
  int open_requests = base::resolve_thread_count(threads) + 1, unsolved = 0;
  for (int k = 0; k < open_requests; ++k) ranks.send(kCoordinator, std::string(1, kRequest));
  PollingBackoff backoff;
  // The solver threads end before the last sweep point only after an exception or a stop request.
  while ((open_requests > 0 || unsolved > 0) && solver.is_running()) {
    bool idle = true;
    if (const auto message = ranks.receive()) {
      idle = false;
      --open_requests;
      if (const auto point = base::parse_number<std::size_t>(message->text)) {
        ++unsolved;
        points.add(*point);
      }
    }
    for (const auto& text : points.take_result_messages()) {
      idle = false;
      --unsolved;
      ++open_requests;
      ranks.send(kCoordinator, text);
    }
    if (idle) {
      backoff.wait();
    } else {
      backoff.reset();
    }
  }
  points.stop_assigning_points();
  try {
    solver.join();
  } catch (const std::exception& error) {
    for (const auto& text : points.take_result_messages()) ranks.send(kCoordinator, text);
    ranks.send(kCoordinator, kFailed + std::string(error.what()));
    throw;
  }
  ranks.send(kCoordinator, std::string(1, kFinished));
}

}  // namespace

void solve_remaining_sweep_points(const SweepPlan& plan, SweepPointSource& points, int threads) {
  const int thread_count = base::resolve_thread_count(threads);
  base::parallel_for(static_cast<std::size_t>(thread_count), thread_count, [&](std::size_t) {
    try {
      for (auto point = points.take_next_sweep_point(); point;
           point = points.take_next_sweep_point()) {
        points.store_solved_point(solve_sweep_point(plan, *point));
      }
    } catch (...) {
      points.stop_assigning_points();
      throw;
    }
  });
}

void solve_sweep_plan(const SweepPlan& plan, const std::filesystem::path& directory,
                      base::Communicator* ranks, int threads,
                      const std::function<JournaledPointQueue&()>& open_queue) {
  if (ranks != nullptr && !ranks->is_first_rank()) {
    run_worker(plan, directory, *ranks, threads);
    return;
  }
  JournaledPointQueue* points = nullptr;
  try {
    points = &open_queue();
  } catch (...) {
    if (ranks != nullptr) serve_workers(*ranks, nullptr, nullptr);
    throw;
  }
  if (ranks != nullptr) {
    run_coordinator(plan, *points, *ranks, threads);
  } else {
    solve_remaining_sweep_points(plan, *points, threads);
  }
}

}  // namespace fpkcheck::sweep
