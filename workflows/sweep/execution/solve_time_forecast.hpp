#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Model of the wall-clock times of all points of a sweep plan, fitted to measured times by least
/// squares. The logarithm of the wall-clock time is a quadratic polynomial of the varied
/// parameters, or of their logarithms on logarithmic axes.
class SolveTimeModel {
 public:
  /// A solved sweep point with the measured wall-clock time of its solution.
  struct Measurement {
    std::size_t point;
    double seconds;
  };

  /// @param measured measured points. Without measured points, the model expects the same
  ///        wall-clock time for all points.
  SolveTimeModel(const SweepPlan& plan, std::span<const Measurement> measured);

  /// Returns the expected seconds of a sweep point, or the measured seconds if the point was
  /// measured.
  double expected_seconds(std::size_t point) const { return expected_[point]; }
  const std::vector<double>& all_expected_seconds() const { return expected_; }

 private:
  std::vector<double> expected_;
};

/// Returns about `count` points that are evenly distributed over the list `candidates`.
/// @param candidates numbers of the candidate points in increasing order
std::vector<std::size_t> evenly_spread_sample(const std::vector<std::size_t>& candidates,
                                              std::size_t count);

enum class SweepPointDispatchRule {
  longest_first,  ///< the next free worker gets the point with the longest expected time
  in_order,       ///< the next free worker gets the next point of the plan
  shards          ///< each of N workers gets every N-th point in advance
};

/// Returns the wall-clock time in which parallel workers solve points with the given solve times.
double parallel_wall_clock_time(std::span<const double> seconds, std::size_t workers,
                                SweepPointDispatchRule dispatch);

/// Expected wall-clock times of a sweep plan, estimated from a sample of its points.
struct SolveTimeForecast {
  std::vector<SolveTimeModel::Measurement> sample{};
  std::vector<double> seconds{};  ///< expected seconds of each point
  double uncertainty = 0;         ///< relative standard error of the sum of `seconds`
  double megabytes = 0;           ///< peak resident memory of the process; 0 if no point was solved
};

/// Solves a sample of the points of a sweep plan, and predicts the wall-clock times of all other
/// points. The forecast of solve times writes no file.
/// @param solved points that were solved before. If the already solved points suffice for the
///        forecast, no further point is solved.
/// @param threads number of threads; 0 for one thread per processor
/// @throws any exception of a solver
SolveTimeForecast forecast_solve_times(const SweepPlan& plan,
                                       const std::vector<SweepPointResult>& solved, int threads);

}  // namespace fpkcheck::sweep
