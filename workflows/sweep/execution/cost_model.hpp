#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"

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

}  // namespace fpkcheck::sweep
