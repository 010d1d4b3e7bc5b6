#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// Model of the wall-clock times of the points of a plan, fitted to measured points. The logarithm
/// of the seconds is a quadratic polynomial of the varied keys (of their logarithms on logarithmic
/// axes), fitted by least squares.
class CostModel {
 public:
  /// A solved point and its wall-clock time.
  struct Measurement {
    std::size_t point;
    double seconds;
  };

  /// @param measured may be empty: then all points have the same expected time
  CostModel(const Plan& plan, std::span<const Measurement> measured);

  /// Expected seconds of a point; the measured seconds where it was measured.
  double expected(std::size_t point) const { return expected_[point]; }
  const std::vector<double>& all() const { return expected_; }

 private:
  std::vector<double> expected_;
};

/// Selects about `count` points, evenly distributed over the candidates: a sample to measure
/// first.
/// @param candidates candidates in increasing order
std::vector<std::size_t> spread_sample(const std::vector<std::size_t>& candidates,
                                       std::size_t count);

}  // namespace fpkcheck::sweep
