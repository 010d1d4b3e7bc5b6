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

#include "base/process/stop.hpp"
#include "methods/side_by_side.hpp"
#include "workflows/sweep/result/point_json.hpp"

namespace fpkcheck::sweep {
namespace {

/// Exponential backoff between two polls for messages: each poll takes time from the solver threads
/// on the same processor. The wait delays no thread, since each thread has a point in reserve.
class Patience {
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

// First letter of a message: its type.
namespace word {
constexpr char kWant = 'w';    // worker to coordinator: request for a point
constexpr char kSolved = 's';  // worker to coordinator: result of a point, and the next request
constexpr char kFailed = 'f';  // worker to coordinator: text of an exception; final message
constexpr char kBye = 'b';     // worker to coordinator: final message
constexpr char kPoint = 'p';   // coordinator to worker: number of a point
constexpr char kNoMore = 'n';  // coordinator to worker: no points remain
}  // namespace word

std::string text_of_point(std::size_t point) { return fmt::format("{}{}", word::kPoint, point); }

std::size_t point_in_text(const std::string& text) {
  std::size_t point = 0;
  std::from_chars(text.data() + 1, text.data() + text.size(), point);
  return point;
}

/// The solver threads of a rank; another thread exchanges messages with the other ranks.
class Solvers {
 public:
  /// @param next blocks until there is a point; empty at the end
  /// @param done called with each solved point
  Solvers(const Plan& plan, int threads, std::function<std::optional<std::size_t>()> next,
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

/// The first rank: assigns the points and collects the results.
class Leader {
 public:
  Leader(const Plan& plan, Progress& progress, base::Ranks& ranks, int threads)
      : progress_(progress),
        ranks_(ranks),
        solvers_(
            plan, methods::number_of_threads(threads), [this] { return next(); },
            [this](SolvedPoint&& solved) { progress_.keep(std::move(solved)); }) {}
  ~Leader() { failed_ = true; }
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

  void run() {
    Patience patience;
    for (int following = ranks_.size() - 1; following > 0 || solvers_.running();) {
      if (const auto failure = solvers_.failure()) give_up(failure);
      const auto message = ranks_.receive();
      if (!message) {
        patience.wait();
        continue;
      }
      patience.reset();
      if (is_last(*message)) --following;
    }
    if (const auto failure = solvers_.failure()) give_up(failure);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::optional<std::size_t> next() { return failed_ ? std::nullopt : progress_.next(); }

  // True for the final message of a rank. Otherwise replies with a point, or that none remain.
  bool is_last(const base::Ranks::Message& message) {
    const char word = message.text.empty() ? word::kFailed : message.text.front();
    if (word == word::kBye) return true;
    if (word == word::kFailed) {
      give_up(std::make_exception_ptr(
          std::runtime_error(fmt::format("rank {}: {}", message.from, message.text.substr(1)))));
      return true;
    }
    if (word == word::kSolved) keep(message.text.substr(1));
    const auto point = next();
    ranks_.send(message.from, point ? text_of_point(*point) : std::string(1, word::kNoMore));
    return false;
  }

  void keep(const std::string& text) try {
    progress_.keep({point_in(results::Json::parse(text)), {}});
  } catch (...) {
    give_up(std::current_exception());
  }

  void give_up(const std::exception_ptr& why) {
    failed_ = true;
    if (!failure_) failure_ = why;
  }

  Progress& progress_;
  base::Ranks& ranks_;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  Solvers solvers_;
};

/// Every other rank: requests points and sends their results.
class Follower {
 public:
  Follower(const Plan& plan, const std::filesystem::path& directory, base::Ranks& ranks,
           int threads)
      : plan_(plan),
        directory_(directory),
        ranks_(ranks),
        threads_(methods::number_of_threads(threads)),
        solvers_(
            plan, threads_, [this] { return next(); },
            [this](SolvedPoint&& solved) { put(std::move(solved)); }) {}
  ~Follower() { end(); }
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  void run() {
    // One request more than threads: a point in reserve, so that no thread waits for a reply.
    for (int k = 0; k <= threads_; ++k) ask(std::string(1, word::kWant));
    int solving = 0;
    Patience patience;
    while (asked_ > 0 || solving > 0) {
      if (const auto failure = solvers_.failure()) {
        tell_failure(failure);
        std::rethrow_exception(failure);
      }
      bool idle = true;
      if (const auto message = ranks_.receive()) {
        idle = false;
        --asked_;
        if (message->text.front() == word::kPoint) {
          ++solving;
          give(point_in_text(message->text));
        }
      }
      for (const auto& text : solved()) {
        idle = false;
        --solving;
        ask(text);
      }
      if (idle) {
        patience.wait();
      } else {
        patience.reset();
      }
    }
    end();
    ranks_.send(0, std::string(1, word::kBye));
  }

 private:
  void ask(const std::string& text) {
    ++asked_;
    ranks_.send(0, text);
  }

  void tell_failure(const std::exception_ptr& failure) {
    end();
    try {
      std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      ranks_.send(0, word::kFailed + std::string(error.what()));
    }
  }

  // Called by the solver threads:
  std::optional<std::size_t> next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_ || base::stop_requested()) return std::nullopt;
    const std::size_t point = waiting_.front();
    waiting_.pop_front();
    return point;
  }
  void put(SolvedPoint&& solved) {
    keep_marginals(plan_, directory_, solved);
    std::string text = word::kSolved + journal_text(solved.result);
    const std::lock_guard lock(mutex_);
    solved_.push_back(std::move(text));
  }

  // Called by the thread that exchanges messages:
  void give(std::size_t point) {
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
  base::Ranks& ranks_;
  int threads_;
  int asked_ = 0;  // requests without a reply
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> waiting_;
  std::vector<std::string> solved_;
  bool ended_ = false;
  Solvers solvers_;
};

}  // namespace

void lead(const Plan& plan, Progress& progress, base::Ranks& ranks, int threads) {
  Leader(plan, progress, ranks, threads).run();
}

void dismiss(base::Ranks& ranks) {
  Patience patience;
  for (int following = ranks.size() - 1; following > 0;) {
    const auto message = ranks.receive();
    if (!message) {
      patience.wait();
    } else if (message->text.front() == word::kBye || message->text.front() == word::kFailed) {
      --following;
    } else {
      ranks.send(message->from, std::string(1, word::kNoMore));
    }
  }
}

void follow(const Plan& plan, const std::filesystem::path& directory, base::Ranks& ranks,
            int threads) {
  Follower(plan, directory, ranks, threads).run();
}

}  // namespace fpkcheck::sweep
