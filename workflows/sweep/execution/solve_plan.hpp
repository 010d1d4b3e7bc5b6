#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/mpi/communicator.hpp"
#include "workflows/sweep/execution/solve_point.hpp"
#include "workflows/sweep/execution/solve_time_forecast.hpp"
#include "workflows/sweep/execution/sweep_shards.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/journal.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Thread-safe queue of the sweep points that remain to be solved. The first points of the queue
/// are a sample from all regions of the sweep plan. When the solve times of the first points
/// suffice for predictions, the queue is sorted by decreasing expected solve time. Long points are
/// therefore solved early, and threads do not wait for a single long point at the end of the sweep.
class SweepPointQueue {
 public:
  struct State {
    std::size_t done = 0,
                total = 0;  ///< number of solved points and number of all points of the queue
    /// Total expected solve time in seconds of all unsolved points; empty until enough points are
    /// measured.
    std::optional<double> remaining_seconds = {};
  };

  /// @param own_points points of this queue, in increasing order
  /// @param solved points that were solved before, for the solve time model; points of other queues
  ///        are allowed
  SweepPointQueue(const SweepPlan& plan, const std::vector<std::size_t>& own_points,
                  const std::vector<SweepPointResult>& solved);

  /// Removes and returns the next point of the queue; empty if no point remains.
  std::optional<std::size_t> take_next_sweep_point();
  /// Records the wall-clock time in which a sweep point was solved. The caller of
  /// take_next_sweep_point() must record every solved point.
  void record_sweep_point_solve_time(std::size_t point, double seconds);

  State point_queue_state() const;

 private:
  void sort_by_time_if_enough_measured();

  const SweepPlan& plan_;
  mutable std::mutex mutex_;
  std::size_t total_;
  std::vector<SolveTimeModel::Measurement> measured_;
  // Waiting points of the queue in reverse order, with the next point at the end.
  std::vector<std::size_t> waiting_;
  // Expected solve time in seconds of each point; empty until enough points are measured.
  std::vector<double> expected_;
  std::size_t unfinished_;
  double remaining_seconds_ = 0;
};

/// Thread-safe source of unsolved sweep points, which also receives the results of the solved
/// points.
class SweepPointSource {
 public:
  virtual ~SweepPointSource() = default;
  /// Removes and returns the next point. If another process assigns the points, the function waits
  /// for the assignment.
  /// @return the next point; empty if no point remains, after a stop request, and after
  /// stop_assigning_points()
  virtual std::optional<std::size_t> take_next_sweep_point() = 0;
  virtual void store_solved_point(SolvedSweepPoint&& solved) = 0;
  /// Ends the assignment of points: take_next_sweep_point() returns no further point.
  virtual void stop_assigning_points() = 0;
};

/// Listener that receives the state of the point queue after each solved point. Several threads
/// call the queue listener, but never at the same time. An exception of the queue listener ends the
/// sweep.
using QueueStateListener = std::function<void(const SweepPointQueue::State&)>;

/// Journal of a sweep, with a queue of the points without a result in the journal.
class JournaledPointQueue final : public SweepPointSource {
 public:
  /// Opens or creates the journal of a sweep in a directory.
  /// @throws the exceptions of SweepJournal's constructor
  JournaledPointQueue(const SweepPlan& plan, const std::filesystem::path& directory,
                      const SweepShard& shard, QueueStateListener listener);

  std::optional<std::size_t> take_next_sweep_point() override;
  void store_solved_point(SolvedSweepPoint&& solved) override;
  void stop_assigning_points() override { closed_ = true; }

  SweepPointQueue::State point_queue_state() const { return queue_.point_queue_state(); }
  /// Returns a line of text with the numbers of solved points, remaining points and damaged lines
  /// of a resumed sweep. The text is empty for a new journal.
  std::string sweep_resumption_text() const;
  /// Returns the results of all solved points of a sweep, beginning with the points of earlier
  /// runs.
  std::vector<SweepPointResult> solved_points() const { return points_; }

 private:
  const SweepPlan& plan_;
  std::filesystem::path directory_;
  std::string journal_name_;
  SweepJournal journal_;
  SweepPointQueue queue_;
  QueueStateListener listener_;
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::vector<SweepPointResult> points_;
};

/// Solves all sweep points that a point source returns. Each thread solves one point at a time.
/// After an exception on a thread, the points in progress are completed, and the exception is
/// rethrown.
/// @param threads number of solver threads; 0 for one thread per processor
void solve_remaining_sweep_points(const SweepPlan& plan, SweepPointSource& points, int threads);

/// Solves the remaining points of a sweep plan on the threads of this process or of all MPI ranks.
/// Under MPI each rank must call solve_sweep_plan(). The first rank, the coordinator, writes the
/// journal, assigns points to free threads by decreasing expected time, and also solves points. All
/// MPI ranks after the first rank, the workers, only solve points. After an exception on a thread
/// or a rank, the points in progress are completed, and the exception is rethrown.
/// @param directory output directory for the marginal densities
/// @param ranks communicator of the MPI ranks; null without MPI
/// @param threads number of threads of this rank; 0 for one thread per processor of the rank
/// @param open_queue function that opens the journal, called only on the first rank. If
///        open_queue() throws an exception, the worker ranks end.
void solve_sweep_plan(const SweepPlan& plan, const std::filesystem::path& directory,
                      base::Communicator* ranks, int threads,
                      const std::function<JournaledPointQueue&()>& open_queue);

}  // namespace fpkcheck::sweep
