#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A model of the wall-clock times of all points of a plan, fitted to the times of measured points.
/// The logarithm of the seconds is a quadratic polynomial of the values of the varied keys, or of
/// the logarithms of these values on logarithmic axes, and is fitted by least squares.
class CostModel {
 public:
  /// A solved point and the measured wall-clock time of its solves.
  struct Measurement {
    std::size_t point;
    double seconds;
  };

  /// @param measured measured points; if there are none, all points have the same expected time
  CostModel(const Plan& plan, std::span<const Measurement> measured);

  /// The expected seconds of a point; for a measured point the measured seconds.
  double expected_seconds(std::size_t point) const { return expected_[point]; }
  const std::vector<double>& all_expected_seconds() const { return expected_; }

 private:
  std::vector<double> expected_;
};

/// Selects about `count` points that are evenly distributed over the candidates. The selected
/// points are the sample whose times are measured first.
/// @param candidates numbers of the candidate points in increasing order
std::vector<std::size_t> evenly_spread_sample(const std::vector<std::size_t>& candidates,
                                              std::size_t count);

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
