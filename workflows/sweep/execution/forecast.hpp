#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workflows/sweep/execution/cost_model.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// The rule by which points are assigned to workers.
enum class DispatchRule {
  longest_first,  ///< to the next free worker, the longest expected point first
  in_order,       ///< to the next free worker, in order
  shards          ///< in advance, every N-th point to the same worker
};

/// The wall-clock time until the last worker has solved its last point.
/// @param seconds wall-clock time of each point
double makespan(std::span<const double> seconds, std::size_t workers, DispatchRule dispatch);

/// The expected wall-clock times of a plan, estimated from a sample of points.
struct Forecast {
  std::vector<CostModel::Measurement> sample{};
  std::vector<double> seconds{};  ///< expected, for each point
  double uncertainty = 0;         ///< relative standard error of their sum
  double megabytes = 0;  ///< largest resident set, all threads together; 0 where nothing was solved
};

/// Solves a sample of the points of a plan, and predicts the times of the other points from the
/// sample and from `solved`. No file is written.
/// @param solved points that were solved before; if these points suffice for the prediction, no
///               further point is solved
/// @param threads number of threads; 0 for one thread per processor
/// @throws any exception of a solver
Forecast forecast(const Plan& plan, const std::vector<PointResult>& solved, int threads);

}  // namespace fpkcheck::sweep
