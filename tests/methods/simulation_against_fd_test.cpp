#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "fd_fpk/solve.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"

// The simulation and the finite volumes share only the problem.
namespace fpkcheck {
namespace {

using transform::StateVariable;

/// Expects L1 distances of the simulated marginals from those of another solution that agree with
/// the expected sampling error. The ratio varies by some tens of per cent.
void expect_within_chance(const mcs::SimulationResult& simulated,
                          const transform::Solution& other) {
  for (const auto& [variable, estimate] : simulated.solution.estimated_marginals) {
    const auto reference = transform::marginal(other, variable, estimate.edges);
    const double l1 = transform::l1_distance(estimate, reference);
    const auto& sampling = simulated.solution.sampling;
    const double chance = (variable == StateVariable::y ? sampling->y : sampling->ydot).value();
    EXPECT_LT(l1, 1.6 * chance) << transform::name(variable);
    EXPECT_GT(l1, 0.5 * chance) << transform::name(variable);
  }
}

/// p(0, v) on the cells of v: the derivative at y = 0 of the polynomial that interpolates the
/// cumulative distribution over y.
std::vector<double> at_the_wall(const transform::GridDensity& grid) {
  constexpr std::size_t kPoints = 6;
  std::vector<double> wall;
  for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
    double slope = 0, cumulative = 0;
    for (std::size_t a = 1; a < kPoints; ++a) {
      cumulative += grid.cell_average(a - 1, j) * (grid.y_edges[a] - grid.y_edges[a - 1]);
      double weight = 1 / grid.y_edges[a];
      for (std::size_t b = 1; b < kPoints; ++b) {
        if (b != a) weight *= -grid.y_edges[b] / (grid.y_edges[a] - grid.y_edges[b]);
      }
      slope += weight * cumulative;
    }
    wall.push_back(slope);
  }
  return wall;
}

/// int |v| p(0, v) dv over v < 0 = int F(v) dv, with F the cumulative distribution from below, by
/// the trapezoidal rule with end correction.
double impact_rate(const transform::GridDensity& grid) {
  const auto wall = at_the_wall(grid);
  double below = 0, rate = 0, width = 0, last = 0;
  for (std::size_t j = 0; grid.v_edges[j + 1] <= 1e-12; ++j) {
    width = grid.v_edges[j + 1] - grid.v_edges[j];
    last = wall[j];
    rate += width * (below + wall[j] * width / 2);
    below += wall[j] * width;
  }
  return rate - width * width / 12 * last;
}

TEST(SimulationAgainstFiniteVolumes, DensitiesDifferBySamplingErrors) {
  for (const auto& problem : {tests::paper_case(4), tests::make_problem({.restitution = 0.7}),
                              tests::make_problem({.rate = 0.3}),
                              tests::make_problem({.restitution = 0.9, .law = "exponential"})}) {
    const auto fd =
        fd_fpk::solve_stationary_density(problem, {.stepper = fd_fpk::StationarySolver::direct});
    ASSERT_EQ(fd.solution.status, transform::Status::ok) << fd.solution.reason;
    expect_within_chance(mcs::simulate_stationary_density(problem, {.time = 4e5}), fd.solution);
  }
}

TEST(SimulationAgainstFiniteVolumes, ImpactRateEqualsTheFluxAtTheWall) {
  for (const auto& problem : {tests::paper_case(1), tests::paper_case(4)}) {
    const auto fd =
        fd_fpk::solve_stationary_density(problem, {.stepper = fd_fpk::StationarySolver::direct});
    const auto [rate, error] =
        mcs::simulate_stationary_density(problem, {.time = 4e5}).summary.impact_rate;
    const double flux = impact_rate(std::get<transform::GridDensity>(*fd.solution.density));
    EXPECT_NEAR(rate, flux, 4 * error) << (rate - flux) / error;
    EXPECT_LT(error, 2e-3 * rate);
  }
}

TEST(SimulationAgainstFiniteVolumes, WhiteNoiseHasTheDensityOfItsEquation) {
  const auto problem = tests::make_problem({.cubic = 1, .restitution = 0.9});
  const auto fd = fd_fpk::solve_stationary_density(
      problem,
      {.equation = problem::DensityEquation::white, .stepper = fd_fpk::StationarySolver::direct});
  expect_within_chance(mcs::simulate_stationary_density(
                           problem, {.equation = problem::DensityEquation::white, .time = 2e5}),
                       fd.solution);
}

TEST(SimulationAgainstFiniteVolumes, TailsAgreeDownTo1eMinus8OfThePeak) {
  const auto problem = tests::paper_case(1);
  const auto fd = fd_fpk::solve_stationary_density(
      problem,
      {.stepper = fd_fpk::StationarySolver::direct, .nx = 90, .nv = 200, .wall_density = 1e-11});
  ASSERT_EQ(fd.solution.status, transform::Status::ok) << fd.solution.reason;
  const auto simulated = mcs::simulate_stationary_density(problem, {.time = 2e5, .tails = true});
  for (const auto& [variable, estimate] : simulated.solution.estimated_marginals) {
    const auto reference = transform::marginal(fd.solution, variable, estimate.edges);
    const double peak = *std::max_element(reference.density.begin(), reference.density.end());
    double least = peak;
    for (std::size_t b = 0; b < estimate.size(); ++b) {
      if (reference.density[b] < 1e-8 * peak) continue;
      const double half = (estimate.upper[b] - estimate.lower[b]) / 2;
      // The finite volumes have an error of one or two per cent in these tails.
      const double own = reference.density[b] < 1e-5 * peak ? 0.03 * reference.density[b] : 0;
      EXPECT_NEAR(estimate.density[b], reference.density[b], 2.5 * half + own)
          << transform::name(variable) << " " << estimate.bin_centre(b) << ": "
          << (estimate.density[b] / reference.density[b] - 1) << " half "
          << half / reference.density[b];
      least = std::min(least, estimate.density[b]);
    }
    EXPECT_LT(least, 5e-8 * peak);
  }
}

}  // namespace
}  // namespace fpkcheck
