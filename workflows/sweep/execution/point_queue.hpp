#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "workflows/sweep/execution/cost_model.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// Points to solve, in the order of their assignment: first a sample from all regions of the plan;
/// as soon as the sample gives expected times, the longest expected point first. So no long point
/// begins when all others are done. Thread-safe.
class PointQueue {
 public:
  /// Counts of the points of this queue, and the remaining time.
  struct State {
    std::size_t done = 0, total = 0;  ///< numbers of points of this queue
    /// Expected seconds of all remaining solves; empty before enough points are measured.
    std::optional<double> remaining_seconds = {};
  };

  /// @param own_points points of this queue, in increasing order
  /// @param solved points that were solved before; those of other queues still count for the cost
  ///        model
  PointQueue(const Plan& plan, const std::vector<std::size_t>& own_points,
             const std::vector<PointResult>& solved);

  /// @return the next point; empty when there is none
  std::optional<std::size_t> next();
  /// Records the wall-clock time of a solved point. Must be called for every solved point.
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
