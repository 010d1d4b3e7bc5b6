#include <gtest/gtest.h>

#include <cmath>

#include "fd_fpk/transient.hpp"
#include "mcs/ensemble.hpp"
#include "paper_cases.hpp"

namespace fpkcheck {
namespace {

// A hardening spring with losses at the wall, under impulses with a mean: no exact solution is
// known. The finite volumes and the simulation share the problem and the start alone.
TEST(TransientAgainstSimulation, MomentsAndMarginalsAgreeWithinStandardErrorsAtAllTimes) {
  const auto problem = tests::make_problem({.cubic = 0.3, .restitution = 0.9, .mean = 0.1});
  const auto fd = fd_fpk::solve_transient(problem, {},
                                          {.until = 3,
                                           .snapshots = 4,
                                           .start_displacement = 0.6,
                                           .start_velocity = 0.8,
                                           .relative_tolerance = 1e-6});
  ASSERT_EQ(fd.status, transform::Status::ok) << fd.reason;
  mcs::EnsembleOptions options{.start_displacement = 0.6,
                               .start_velocity = 0.8,
                               .trajectories = 200000,
                               .seed = 3,
                               .y_edges = fd.y_edges,
                               .v_edges = fd.v_edges};
  for (const auto& s : fd.snapshots) options.times.push_back(s.time);
  const auto simulated = mcs::simulate_ensemble(problem, options);

  // 30 moments: four standard errors are exceeded by chance once in 500 seeds.
  constexpr double kStandardErrors = 4;
  for (std::size_t n = 0; n < simulated.size(); ++n) {
    const auto& a = fd.snapshots[n];
    const auto& b = simulated[n];
    SCOPED_TRACE(a.time);
    for (const auto moment :
         {&transform::Moments::y1, &transform::Moments::y2, &transform::Moments::y4,
          &transform::Moments::v1, &transform::Moments::v2, &transform::Moments::v4}) {
      EXPECT_NEAR(a.moments.*moment, b.moments.*moment,
                  kStandardErrors * b.standard_errors.*moment);
    }
    // Expected L1 distance by sampling alone: sum of sqrt(2/pi) standard errors times widths. Its
    // relative deviation is a tenth.
    const auto l1_in_units_of_chance = [](const std::vector<double>& p,
                                          const transform::Marginal& q) {
      double l1 = 0, chance = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        l1 += std::abs(p[i] - q.density[i]) * q.width(i);
        chance += std::sqrt(2 / M_PI) * (q.upper[i] - q.lower[i]) / (2 * 1.96) * q.width(i);
      }
      return l1 / chance;
    };
    EXPECT_LT(l1_in_units_of_chance(a.y, b.y), 1.5);
    EXPECT_LT(l1_in_units_of_chance(a.v, b.v), 1.5);
  }
}

}  // namespace
}  // namespace fpkcheck
