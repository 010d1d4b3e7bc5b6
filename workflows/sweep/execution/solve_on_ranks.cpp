#include "workflows/sweep/execution/solve_on_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "workflows/sweep/result/point_json.hpp"

namespace fpkcheck::sweep {
namespace {

/// Exponential backoff between two polls for messages, since each poll takes processor time from
/// the solver threads. The waiting time delays no solver thread, since a point is in reserve on
/// each rank.
class Backoff {
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

// The types of messages. The first letter of a message is its type.
namespace message_type {
constexpr char kRequest = 'w';   // worker to coordinator: request for a point
constexpr char kSolved = 's';    // worker to coordinator: result of a point, and the next request
constexpr char kFailed = 'f';    // worker to coordinator: text of an exception; final message
constexpr char kFinished = 'b';  // worker to coordinator: final message
constexpr char kPoint = 'p';     // coordinator to worker: number of a point
constexpr char kNoPointsLeft = 'n';  // coordinator to worker: no points remain
}  // namespace message_type

std::string point_message(std::size_t point) {
  return fmt::format("{}{}", message_type::kPoint, point);
}

std::size_t parse_point_message(const std::string& text) {
  std::size_t point = 0;
  std::from_chars(text.data() + 1, text.data() + text.size(), point);
  return point;
}

/// The solver threads of a rank. A separate thread exchanges messages with the other ranks.
class SolverThreadPool {
 public:
  /// @param next returns the next point, and blocks until a point is available; empty if no points
  ///             remain
  /// @param done function that is called with each solved point
  SolverThreadPool(const Plan& plan, int threads, std::function<std::optional<std::size_t>()> next,
                   std::function<void(SolvedPoint&&)> done)
      : running_(threads) {
    for (int t = 0; t < threads; ++t) {
      threads_.emplace_back([this, &plan, next, done] {
        try {
          for (auto point = next(); point; point = next()) done(solve_point(plan, *point));
        } catch (...) {
          const std::lock_guard lock(mutex_);
          if (!failure_) failure_ = std::current_exception();
        }
        --running_;
      });
    }
  }

  bool running() const { return running_ > 0; }
  std::exception_ptr failure() {
    const std::lock_guard lock(mutex_);
    return failure_;
  }

 private:
  std::atomic<int> running_;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;  // last member: destroyed, and so joined, before the others
};

/// The coordinator on the first rank, which assigns the points and collects the results.
class Coordinator {
 public:
  Coordinator(const Plan& plan, JournaledQueue& progress, base::Communicator& ranks, int threads)
      : progress_(progress),
        ranks_(ranks),
        solvers_(
            plan, base::number_of_threads(threads), [this] { return next(); },
            [this](SolvedPoint&& solved) { progress_.store(std::move(solved)); }) {}
  ~Coordinator() { failed_ = true; }
  Coordinator(const Coordinator&) = delete;
  Coordinator& operator=(const Coordinator&) = delete;

  void run() {
    Backoff backoff;
    for (int active_workers = ranks_.size() - 1; active_workers > 0 || solvers_.running();) {
      if (const auto failure = solvers_.failure()) set_failure(failure);
      const auto message = ranks_.receive();
      if (!message) {
        backoff.wait();
        continue;
      }
      backoff.reset();
      if (is_final_message(*message)) --active_workers;
    }
    if (const auto failure = solvers_.failure()) set_failure(failure);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::optional<std::size_t> next() { return failed_ ? std::nullopt : progress_.take_next_point(); }

  // Processes a message of a worker, and replies with a point or with the message that no points
  // remain. Returns whether the message was the final message of the worker; a final message has no
  // reply.
  bool is_final_message(const base::Communicator::Message& message) {
    const char message_type = message.text.empty() ? message_type::kFailed : message.text.front();
    if (message_type == message_type::kFinished) return true;
    if (message_type == message_type::kFailed) {
      set_failure(std::make_exception_ptr(
          std::runtime_error(fmt::format("rank {}: {}", message.from, message.text.substr(1)))));
      return true;
    }
    if (message_type == message_type::kSolved) store(message.text.substr(1));
    const auto point = next();
    ranks_.send(message.from,
                point ? point_message(*point) : std::string(1, message_type::kNoPointsLeft));
    return false;
  }

  void store(const std::string& text) try {
    progress_.store({point_from_json(results::Json::parse(text)), {}});
  } catch (...) {
    set_failure(std::current_exception());
  }

  void set_failure(const std::exception_ptr& why) {
    failed_ = true;
    if (!failure_) failure_ = why;
  }

  JournaledQueue& progress_;
  base::Communicator& ranks_;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  SolverThreadPool solvers_;
};

/// A worker on any other rank, which requests points and sends the results.
class Worker {
 public:
  Worker(const Plan& plan, const std::filesystem::path& directory, base::Communicator& ranks,
         int threads)
      : plan_(plan),
        directory_(directory),
        ranks_(ranks),
        threads_(base::number_of_threads(threads)),
        solvers_(
            plan, threads_, [this] { return next(); },
            [this](SolvedPoint&& solved) { store_result(std::move(solved)); }) {}
  ~Worker() { end(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void run() {
    // The number of open requests exceeds the number of threads by one, so that one point is in
    // reserve and no thread waits for a reply.
    for (int k = 0; k <= threads_; ++k) send_request(std::string(1, message_type::kRequest));
    int solving = 0;
    Backoff backoff;
    while (open_requests_ > 0 || solving > 0) {
      if (const auto failure = solvers_.failure()) {
        send_failure(failure);
        std::rethrow_exception(failure);
      }
      bool idle = true;
      if (const auto message = ranks_.receive()) {
        idle = false;
        --open_requests_;
        if (message->text.front() == message_type::kPoint) {
          ++solving;
          add_point(parse_point_message(message->text));
        }
      }
      for (const auto& text : solved()) {
        idle = false;
        --solving;
        send_request(text);
      }
      if (idle) {
        backoff.wait();
      } else {
        backoff.reset();
      }
    }
    end();
    ranks_.send(0, std::string(1, message_type::kFinished));
  }

 private:
  void send_request(const std::string& text) {
    ++open_requests_;
    ranks_.send(0, text);
  }

  void send_failure(const std::exception_ptr& failure) {
    end();
    try {
      std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      ranks_.send(0, message_type::kFailed + std::string(error.what()));
    }
  }

  // The following functions are called by the solver threads.
  std::optional<std::size_t> next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_ || base::stop_requested()) return std::nullopt;
    const std::size_t point = waiting_.front();
    waiting_.pop_front();
    return point;
  }
  void store_result(SolvedPoint&& solved) {
    write_marginals(plan_, directory_, solved);
    std::string text = message_type::kSolved + journal_line(solved.result);
    const std::lock_guard lock(mutex_);
    solved_.push_back(std::move(text));
  }

  // The following functions are called by the thread that exchanges messages.
  void add_point(std::size_t point) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(point);
    changed_.notify_one();
  }
  std::vector<std::string> solved() {
    const std::lock_guard lock(mutex_);
    return std::exchange(solved_, {});
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  const Plan& plan_;
  std::filesystem::path directory_;
  base::Communicator& ranks_;
  int threads_;
  int open_requests_ = 0;  // requests without a reply
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> waiting_;
  std::vector<std::string> solved_;
  bool ended_ = false;
  SolverThreadPool solvers_;
};

}  // namespace

void run_coordinator(const Plan& plan, JournaledQueue& progress, base::Communicator& ranks,
                     int threads) {
  Coordinator(plan, progress, ranks, threads).run();
}

void release_workers(base::Communicator& ranks) {
  Backoff backoff;
  for (int active_workers = ranks.size() - 1; active_workers > 0;) {
    const auto message = ranks.receive();
    if (!message) {
      backoff.wait();
    } else if (message->text.front() == message_type::kFinished ||
               message->text.front() == message_type::kFailed) {
      --active_workers;
    } else {
      ranks.send(message->from, std::string(1, message_type::kNoPointsLeft));
    }
  }
}

void run_worker(const Plan& plan, const std::filesystem::path& directory, base::Communicator& ranks,
                int threads) {
  Worker(plan, directory, ranks, threads).run();
}

}  // namespace fpkcheck::sweep
