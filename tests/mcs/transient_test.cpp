#include "mcs/transient.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "exact/linear_moments.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Status;
using transform::TransientRequest;

constexpr double kStartY = 0.5, kStartV = 0.8;

TransientRequest request(double until, int snapshots) {
  return {.start = {.displacement_deviation = kStartY, .velocity_deviation = kStartV},
          .until = until,
          .snapshots = snapshots,
          .y_edges = {0, 0.5, 1, 2, 4},
          .v_edges = {-4, -1, 0, 1, 4}};
}

// With an elastic wall at the equilibrium of a linear oscillator y = |z|, and E[z^2], E[z'^2] have
// closed forms, for impulses of any law. At the start the density of y' is Gaussian.
TEST(SimulationOverTime, HasTheExactMomentsOfTheLinearOscillator) {
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const transform::Transient result =
      estimate_transient(problem, {.time = 2e5, .seed = 3}, request(4, 4));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  ASSERT_EQ(result.snapshots.size(), 5u);
  EXPECT_TRUE(result.has_standard_errors);
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_at(
        problem, {.var_z = kStartY * kStartY, .var_v = kStartV * kStartV}, s.time);
    ASSERT_TRUE(s.error);
    const auto& error = s.error->moments;
    EXPECT_NEAR(s.moments.y2, exact.zz, 4 * error.y2);
    EXPECT_NEAR(s.moments.v2, exact.vv, 4 * error.v2);
    // About 50 000 paths: the standard error of a mean square is 1.4 to 3 times mean / sqrt(paths).
    EXPECT_GT(error.v2, 1.2 * exact.vv / std::sqrt(50e3));
    EXPECT_LT(error.v2, 4 * exact.vv / std::sqrt(50e3));
  }
  const auto& start = result.snapshots.front();
  const double probability = std::erf(1 / kStartV / std::sqrt(2)) / 2;  // of 0 < y' < 1
  EXPECT_NEAR(start.ydot.density[2], probability, 4 * std::sqrt(0.25 / 50e3));
  EXPECT_LT(start.ydot.lower[2], start.ydot.density[2]);
  EXPECT_GT(start.ydot.upper[2], start.ydot.density[2]);
}

TEST(SimulationOverTime, GivesTheSameResultForAnyNumberOfThreads) {
  const auto problem = tests::paper_case(1);
  const auto one = estimate_transient(problem, {.time = 5e3, .threads = 1}, request(1, 2));
  const auto three = estimate_transient(problem, {.time = 5e3, .threads = 3}, request(1, 2));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(one.snapshots[k].moments.y2, three.snapshots[k].moments.y2);
    EXPECT_EQ(one.snapshots[k].ydot.density, three.snapshots[k].ydot.density);
  }
}

TEST(SimulationOverTime, RefusesAMeanBehindTheWall) {
  TransientRequest behind = request(1, 1);
  behind.start.mean_displacement = -0.5;
  EXPECT_THROW(estimate_transient(tests::paper_case(1), {}, behind), InputError);
}

}  // namespace
}  // namespace fpkcheck::mcs
