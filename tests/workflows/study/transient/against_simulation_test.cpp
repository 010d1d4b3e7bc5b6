#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fd_fpk/transient.hpp"
#include "mcs/scalar_trajectory.hpp"
#include "mcs/simulation/initial_state_sampler.hpp"
#include "paper_cases.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck {
namespace {

constexpr std::uint32_t kTrajectories = 200000;
constexpr double kStartDisplacement = 0.6, kStartVelocity = 0.8;

/// Sums over the trajectories at one time.
struct EnsembleSums {
  transform::Moments powers{}, squares{};  // sums of the powers, and of their squares
  std::vector<double> y_counts, v_counts;  // numbers in the bins

  static void count(std::vector<double>& counts, const std::vector<double>& edges, double x) {
    const auto bin = std::ranges::upper_bound(edges, x) - edges.begin() - 1;
    if (bin >= 0 && bin + 1 < std::ssize(edges)) ++counts[static_cast<std::size_t>(bin)];
  }
};

/// Simulates independent trajectories from the Gaussian start folded to y >= 0.
std::vector<EnsembleSums> simulate_ensemble(const problem::Problem& problem,
                                            const std::vector<double>& times,
                                            const std::vector<double>& y_edges,
                                            const std::vector<double>& v_edges) {
  std::vector<EnsembleSums> all(times.size());
  for (EnsembleSums& sums : all) {
    sums.y_counts.resize(y_edges.size() - 1);
    sums.v_counts.resize(v_edges.size() - 1);
  }
  const mcs::SimulatedOscillator oscillator = tests::oscillator_of(problem);
  for (std::uint32_t n = 0; n < kTrajectories; ++n) {
    const mcs::ImpulseSource source(problem.impulses, 3, n);
    tests::Trajectory trajectory(
        oscillator, source, mcs::folded_initial_state(source, kStartDisplacement, kStartVelocity),
        0.9);
    tests::NullObserver no_observer;
    double time = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      trajectory.advance(times[k] - time, no_observer);
      time = times[k];
      const auto [y, v] = trajectory.state();
      const transform::Moments powers{y, y * y, y * y * y * y, v, v * v, v * v * v * v};
      for (const auto& [name, symbol, moment, size] : transform::kMoments) {
        all[k].powers.*moment += powers.*moment;
        all[k].squares.*moment += powers.*moment * powers.*moment;
      }
      EnsembleSums::count(all[k].y_counts, y_edges, y);
      EnsembleSums::count(all[k].v_counts, v_edges, v);
    }
  }
  return all;
}

/// L1 distance of a density and simulated counts, relative to the expected L1 distance by sampling
/// alone, sum of sqrt(2/pi) standard errors times widths.
double l1_in_units_of_chance(const std::vector<double>& density, const std::vector<double>& edges,
                             const std::vector<double>& counts) {
  double l1 = 0, chance = 0;
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double share = counts[i] / kTrajectories;
    l1 += std::abs(density[i] * (edges[i + 1] - edges[i]) - share);
    chance += std::sqrt(2 / M_PI * share * (1 - share) / kTrajectories);
  }
  return l1 / chance;
}

// A hardening spring with losses at the wall, under impulses with a mean: no exact solution is
// known. The finite volumes and the simulation share the problem and the start alone.
TEST(TransientAgainstSimulation, MomentsAndMarginalsAgreeWithinStandardErrorsAtAllTimes) {
  const auto problem = tests::make_problem({.cubic = 0.3, .restitution = 0.9, .mean = 0.1});
  const auto fd = fd_fpk::solve_transient(problem, {.max_seconds = 120},
                                          {.until = 3,
                                           .snapshots = 4,
                                           .start_displacement = kStartDisplacement,
                                           .start_velocity = kStartVelocity,
                                           .relative_tolerance = 1e-6});
  ASSERT_EQ(fd.status, transform::Status::ok) << fd.reason;
  std::vector<double> times;
  for (const auto& s : fd.snapshots) times.push_back(s.time);
  const auto simulated = simulate_ensemble(problem, times, fd.y_edges, fd.v_edges);

  // 30 moments: four standard errors are exceeded by chance once in 500 seeds.
  constexpr double kStandardErrors = 4;
  for (std::size_t n = 0; n < simulated.size(); ++n) {
    const auto& a = fd.snapshots[n];
    const auto& b = simulated[n];
    SCOPED_TRACE(a.time);
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      const double mean = b.powers.*moment / kTrajectories;
      const double variance = b.squares.*moment / kTrajectories - mean * mean;
      EXPECT_NEAR(a.moments.*moment, mean, kStandardErrors * std::sqrt(variance / kTrajectories));
    }
    // The relative deviation of the L1 distance by sampling alone is a tenth.
    EXPECT_LT(l1_in_units_of_chance(a.y, fd.y_edges, b.y_counts), 1.5);
    EXPECT_LT(l1_in_units_of_chance(a.v, fd.v_edges, b.v_counts), 1.5);
  }
}

}  // namespace
}  // namespace fpkcheck
