#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/execution/forecast.hpp"
#include "workflows/sweep/execution/shards.hpp"
#include "workflows/sweep/execution/solve_point.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/journal.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A thread-safe queue of the points to solve. The first points are a sample from all regions of
/// the plan. When the measured times of the sample suffice to predict times, the queue is sorted by
/// decreasing expected time, so that no thread begins a long point when all other points are
/// solved.
class PointQueue {
 public:
  /// The state of the queue: numbers of points, and expected remaining time.
  struct State {
    std::size_t done = 0, total = 0;  ///< numbers of points of this queue
    /// The sum of the expected seconds of all unsolved points; empty until enough points are
    /// measured.
    std::optional<double> remaining_seconds = {};
  };

  /// @param own_points points of this queue, in increasing order
  /// @param solved points that were solved before; points of other queues also contribute to the
  ///        cost model
  PointQueue(const Plan& plan, const std::vector<std::size_t>& own_points,
             const std::vector<PointResult>& solved);

  /// Removes the next point from the queue.
  /// @return the point; empty if the queue is empty
  std::optional<std::size_t> take_next_point();
  /// Records the wall-clock time of a solved point. record_solved must be called for every solved
  /// point.
  void record_solved(std::size_t point, double seconds);

  State state() const;

 private:
  void sort_if_enough_measured();

  const Plan& plan_;
  mutable std::mutex mutex_;
  std::size_t total_;
  std::vector<CostModel::Measurement> measured_;
  std::vector<std::size_t> waiting_;  // in reverse order: the next point is the last element
  std::vector<double> expected_;      // empty until enough points are measured
  std::size_t unfinished_;
  double remaining_seconds_ = 0;
};

/// A source of the points that remain to be solved, which receives the results of these points. The
/// class is thread-safe.
class PointSource {
 public:
  virtual ~PointSource() = default;
  /// Removes the next point, and waits for this point if another process assigns the points.
  /// @return the point; empty if no point remains, after a stop request, and after close()
  virtual std::optional<std::size_t> take_next_point() = 0;
  /// Stores the result of a point.
  virtual void store(SolvedPoint&& solved) = 0;
  /// Ends the assignment of points: take_next_point() returns no further point.
  virtual void close() = 0;
};

/// A function that is called with the state of the queue after each solved point. Several threads
/// call the listener, but never concurrently. An exception of the listener ends the sweep.
using QueueStateListener = std::function<void(const PointQueue::State&)>;

/// The journal of a sweep, with a queue of the points that the journal lacks. A solved point moves
/// from the queue to the journal.
class JournaledQueue final : public PointSource {
 public:
  /// Opens the journal in the directory, or creates a new journal.
  /// @throws the exceptions of Journal's constructor
  JournaledQueue(const Plan& plan, const std::filesystem::path& directory, const Shard& shard,
                 QueueStateListener listener);

  std::optional<std::size_t> take_next_point() override;
  /// Writes the result of a solved point to the journal.
  void store(SolvedPoint&& solved) override;
  void close() override { closed_ = true; }

  PointQueue::State state() const { return queue_.state(); }
  /// A line of text about a resumed sweep: the number of points that are kept, the number of points
  /// that remain, and the number of points that are solved again because of damaged lines. The text
  /// is empty for a new journal.
  std::string resumption_text() const;
  /// The results of all solved points; points of earlier runs come first.
  std::vector<PointResult> points() const { return points_; }

 private:
  const Plan& plan_;
  std::filesystem::path directory_;
  std::string journal_name_;
  Journal journal_;
  PointQueue queue_;
  QueueStateListener listener_;
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::vector<PointResult> points_;
};

}  // namespace fpkcheck::sweep
