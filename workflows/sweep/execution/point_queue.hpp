#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "workflows/sweep/execution/cost_model.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

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

}  // namespace fpkcheck::sweep
