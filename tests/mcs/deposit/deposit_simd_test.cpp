#include "mcs/deposit/deposit_simd.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace fpkcheck::mcs {
namespace {

std::vector<double> even_knots(double from, double to, int cells) {
  std::vector<double> all(5, from);
  for (int k = 0; k <= cells; ++k) all.push_back(from + (to - from) * k / cells);
  all.insert(all.end(), 5, to);
  return all;
}

// States with NaN or infinity make a simulation fail, but cause no undefined behaviour.
TEST(DepositLanes, AcceptsNonfiniteAndDistantStates) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInfinity = std::numeric_limits<double>::infinity();
  const DepositPlan plan({.y_knots = even_knots(0, 4, 16),
                          .v_knots = even_knots(-5, 5, 40),
                          .lattice_begin = -6,
                          .lattice_spacing = 0.05,
                          .lattice_points = 241,
                          .y_bins = {.first = -0.2, .spacing = 0.2, .count = 24},
                          .v_bins = {.first = -6, .spacing = 0.4, .count = 31}},
                         3, 0.25);
  DepositedSums deposit(plan.grid);
  for (const double x : {kNan, -kNan, kInfinity, -kInfinity, 1e300, -1e300}) {
    EXPECT_EQ(evaluate_splines(plan.y, x).first, x > 0 ? 15 : 0) << x;
    deposit_sample(plan, deposit, 1, x, 1, 1);
    deposit_sample(plan, deposit, x, 1, 1, 1);
    deposit_impact(plan, deposit, 0, x, -x, 1);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
