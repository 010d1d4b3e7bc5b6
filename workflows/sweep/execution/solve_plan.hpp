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

/// A function that is called with the state of the queue after each solved point. Several threads
/// call the listener, but never concurrently. An exception of the listener ends the sweep.
using QueueStateListener = std::function<void(const PointQueue::State&)>;

/// The journal of a sweep, with a queue of the points that the journal lacks. A solved point moves
/// from the queue to the journal. The class is thread-safe.
class JournaledQueue {
 public:
  /// Opens the journal in the directory, or creates a new journal.
  /// @throws the exceptions of Journal's constructor
  JournaledQueue(const Plan& plan, const std::filesystem::path& directory, const Shard& shard,
                 QueueStateListener listener);

  /// Removes the next point from the queue; empty if no point remains, or after a stop request.
  std::optional<std::size_t> take_next_point();
  /// Writes the result of a solved point to the journal.
  void store(SolvedPoint&& solved);

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
  std::mutex mutex_;
  std::vector<PointResult> points_;
};

/// Writes the marginal densities of a point to marginals/NUMBER.csv. No file is written if the
/// point has no marginal density.
/// @throws std::runtime_error with a message of one line
void write_marginals(const Plan& plan, const std::filesystem::path& directory,
                     const SolvedPoint& solved);

/// Solves the remaining points of the queue; each thread solves one point at a time.
/// @param threads number of threads; 0 for one thread per processor
void solve_remaining_points(const Plan& plan, JournaledQueue& progress, int threads);

}  // namespace fpkcheck::sweep
