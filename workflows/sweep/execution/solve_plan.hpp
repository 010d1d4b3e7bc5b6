#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "workflows/sweep/execution/point_queue.hpp"
#include "workflows/sweep/execution/shard.hpp"
#include "workflows/sweep/execution/solve_point.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/journal.hpp"

namespace fpkcheck::sweep {

/// Called with the state of the queue after each point, by several threads but never concurrently.
/// An exception of the listener ends the sweep.
using QueueStateListener = std::function<void(const PointQueue::State&)>;

/// The journal of a sweep and the queue of the points that the journal lacks. A solved point moves
/// from the queue to the journal. Thread-safe.
class JournaledQueue {
 public:
  /// Opens the journal in the directory, or creates it.
  /// @throws the exceptions of Journal's constructor
  JournaledQueue(const Plan& plan, const std::filesystem::path& directory, const Shard& shard,
                 QueueStateListener listener);

  /// The next point to solve; empty when there is none, or after a request to stop.
  std::optional<std::size_t> next();
  /// Stores the result of a point.
  void store(SolvedPoint&& solved);

  PointQueue::State state() const { return queue_.state(); }
  /// One line for a sweep that resumes: numbers of points that are kept and that remain, and of
  /// points that are solved again because of damaged lines. Empty for a new journal.
  std::string resumed_text() const;
  /// Results of all solved points, those of earlier runs first.
  std::vector<PointResult> points() const { return points_; }

 private:
  const Plan& plan_;
  std::filesystem::path directory_;
  std::string journal_name_;
  Journal journal_;
  PointQueue queue_;
  QueueStateListener listener_;
  std::mutex mutex_;
  std::vector<PointResult> points_;
};

/// Writes the marginal densities of a point, if it has any, to marginals/NUMBER.csv.
/// @throws std::runtime_error with a message of one line
void write_marginals(const Plan& plan, const std::filesystem::path& directory,
                     const SolvedPoint& solved);

/// Solves the remaining points, one point at a time on each thread.
/// @param threads 0 for one per processor
void solve_remaining(const Plan& plan, JournaledQueue& progress, int threads);

}  // namespace fpkcheck::sweep
