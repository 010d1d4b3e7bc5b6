#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// How long the points of a plan take, from some that were measured: the logarithm of the seconds as
/// a quadratic polynomial of the varied keys (logarithms of those that are spaced so), by least
/// squares.
class CostModel {
 public:
  /// A point that was solved, and the seconds that it took.
  struct Measured {
    std::size_t point;
    double seconds;
  };

  /// @param measured may be empty: then all points are expected to take as long
  CostModel(const Plan& plan, std::span<const Measured> measured);

  /// Seconds of a point; its own where it was measured.
  double expected(std::size_t point) const { return expected_[point]; }
  const std::vector<double>& all() const { return expected_; }

 private:
  std::vector<double> expected_;
};

/// About `count` points spread over a plan: what is measured first.
/// @param among in increasing order
std::vector<std::size_t> spread(const std::vector<std::size_t>& among, std::size_t count);

}  // namespace fpkcheck::sweep
