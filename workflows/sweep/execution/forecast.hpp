#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Model of the wall-clock times of all points of a plan, fitted to measured times by least
/// squares. The logarithm of the seconds is a quadratic polynomial of the varied values, or of
/// their logarithms on logarithmic axes.
class CostModel {
 public:
  /// A solved point with the measured wall-clock time of its solution.
  struct Measurement {
    std::size_t point;
    double seconds;
  };

  /// @param measured measured points. Without measured points, all points have the same expected
  /// time.
  CostModel(const Plan& plan, std::span<const Measurement> measured);

  /// Returns the expected seconds of a point, or the measured seconds if the point was measured.
  double expected_seconds(std::size_t point) const { return expected_[point]; }
  const std::vector<double>& all_expected_seconds() const { return expected_; }

 private:
  std::vector<double> expected_;
};

/// Selects about `count` evenly distributed points from the candidates.
/// @param candidates numbers of the candidate points in increasing order
std::vector<std::size_t> evenly_spread_sample(const std::vector<std::size_t>& candidates,
                                              std::size_t count);

enum class DispatchRule {
  longest_first,  ///< the next free worker gets the point with the longest expected time
  in_order,       ///< the next free worker gets the next point of the plan
  shards          ///< each of N workers gets every N-th point in advance
};

/// Returns the wall-clock time until the last worker has solved its last point.
double makespan(std::span<const double> seconds, std::size_t workers, DispatchRule dispatch);

/// Expected wall-clock times of a plan, estimated from a sample of points.
struct Forecast {
  std::vector<CostModel::Measurement> sample{};
  std::vector<double> seconds{};  ///< expected seconds of each point
  double uncertainty = 0;         ///< relative standard error of the sum of `seconds`
  double megabytes = 0;           ///< peak resident memory of the process; 0 if no point was solved
};

/// Solves a sample of the points of a plan, and predicts the times of the other points. The
/// forecast writes no file.
/// @param solved points that were solved before. If these points suffice for the forecast, no
/// further point is solved.
/// @param threads number of threads; 0 for one thread per processor
/// @throws any exception of a solver
Forecast forecast(const Plan& plan, const std::vector<PointResult>& solved, int threads);

}  // namespace fpkcheck::sweep
