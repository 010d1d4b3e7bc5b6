#include "fd_fpk/transient_with_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/linear_moments.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// The error estimate covers the error, and is not more than a hundred times as large.
TEST(TransientWithError, CoversTheErrorOfTheLinearOscillator) {
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const double s_y = 0.6, s_v = 0.9;
  const transform::TransientDensities result = solve_transient_with_error(
      problem, {.equation = DensityEquation::white, .refinement = 0.8},
      {.start = {.displacement_deviation = s_y, .velocity_deviation = s_v},
       .until = 3,
       .snapshots = 3,
       .y_edges = {0, 1, 2, 5},
       .v_edges = {-5, -1, 0, 1, 5}});
  ASSERT_EQ(result.status, transform::Status::ok) << result.reason;
  ASSERT_EQ(result.snapshots.size(), 4u);
  double largest_error = 0, largest_estimate = 0, largest_l1_estimate = 0;
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    ASSERT_TRUE(s.error);
    const auto exact =
        exact::linear_moments_at(problem, {.var_z = s_y * s_y, .var_v = s_v * s_v}, s.time);
    EXPECT_LE(std::abs(s.moments.v2 - exact.vv), s.error->moments.v2 + 1e-5);
    EXPECT_LE(std::abs(s.moments.y2 - exact.zz), s.error->moments.y2 + 1e-5);
    largest_error = std::max(largest_error, std::abs(s.moments.v2 - exact.vv));
    largest_estimate = std::max(largest_estimate, s.error->moments.v2);
    // p(y) is twice a Gaussian on y >= 0.
    double l1 = 0;
    for (std::size_t b = 0; b < s.y.size(); ++b) {
      const auto probability = [&](double y) { return std::erf(y / std::sqrt(2 * exact.zz)); };
      l1 += std::abs(s.y.density[b] * s.y.bin_width(b) -
                     (probability(s.y.edges[b + 1]) - probability(s.y.edges[b])));
    }
    EXPECT_LE(l1, s.error->y_l1 + 1e-5);
    largest_l1_estimate = std::max(largest_l1_estimate, s.error->y_l1);
    double mass = 0;
    for (std::size_t b = 0; b < s.y.size(); ++b) mass += s.y.density[b] * s.y.bin_width(b);
    EXPECT_NEAR(mass, 1, 1e-6);
  }
  EXPECT_LT(largest_estimate, 100 * largest_error);
  EXPECT_LT(largest_l1_estimate, 1e-2);
}

// The limit of the cells binds for a narrow initial density, and the coarse grid is still coarser:
// an estimate from two equal grids would contain the error of the time steps alone.
TEST(TransientWithError, CoversTheErrorOfANarrowInitialDensity) {
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const double s_y = 0.1, s_v = 0.1;
  const transform::TransientDensities result = solve_transient_with_error(
      problem, {.equation = DensityEquation::white},
      {.start = {.displacement_deviation = s_y, .velocity_deviation = s_v},
       .until = 0.2,
       .snapshots = 1,
       .y_edges = {0, 0.05, 0.1, 0.2, 5},
       .v_edges = {-5, 0, 5}});
  ASSERT_EQ(result.snapshots.size(), 2u) << result.reason;
  const auto& s = result.snapshots.back();
  const auto exact =
      exact::linear_moments_at(problem, {.var_z = s_y * s_y, .var_v = s_v * s_v}, s.time);
  ASSERT_TRUE(s.error);
  EXPECT_LE(std::abs(s.moments.v2 - exact.vv), s.error->moments.v2 + 1e-6);
  EXPECT_LE(std::abs(s.moments.y2 - exact.zz), s.error->moments.y2 + 1e-6);
  EXPECT_GT(s.error->y_l1, 0);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
