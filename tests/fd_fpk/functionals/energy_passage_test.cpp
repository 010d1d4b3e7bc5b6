#include "fd_fpk/functionals/energy_passage.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fd_fpk/functionals/energy_level_grid.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;
using transform::FirstPassageResult;
using transform::Status;

// Returns the mean time from a state to the passage of an energy level.
double mean_time(const System& system, const BackwardEquationExcitation& excitation, double level,
                 double y, double v, int displacement_count, int velocity_count) {
  const problem::EffectivePotential potential(system);
  const auto interval =
      problem::UndampedOrbits({.name = "", .system = system}).half_cycles(level).front();
  const EnergyLevelGrid grid(system, potential, interval, level, displacement_count, velocity_count,
                             excitation);
  const Eigen::SparseLU<SparseColumnMatrix> lu(grid.backward_matrix());
  const Eigen::VectorXd times = lu.solve(Eigen::VectorXd::Constant(grid.size(), -1));
  return grid.interpolation_weights_at_state(y, v).dot(times);
}

// In a box without a spring the velocity is a random walk, or a Wiener process, up to its sign.
class ElasticBox : public ::testing::Test {
 protected:
  const System system_{{.damping = 0, .stiffness = 0, .cubic = 0},
                       {.left = 0, .left_restitution = 1, .right = 1.5, .right_restitution = 1}};
  const double level_ = 2;  // at the speed 2
};

TEST_F(ElasticBox, HasTheExactMeanTimeUnderNoise) {
  const double exact = (4 - 0.7 * 0.7) / (2 * 0.3);
  EXPECT_NEAR(mean_time(system_, {.diffusion = 0.3}, level_, 0.4, -0.7, 12, 12), exact, 1e-10);
  EXPECT_NEAR(mean_time(system_, {.diffusion = 0.3}, level_, 0, 0, 12, 12), 4 / 0.6, 1e-10);
}

// For Laplace amplitudes of scale b, T - 1 / lambda = E T(v + Y) solves a differential equation of
// second order: T = (1 + w / b + (w^2 - v^2) / (2 b^2)) / lambda with the speed w on the level.
TEST_F(ElasticBox, HasTheExactMeanTimeUnderImpulses) {
  const double scale = 0.5, rate = 1.3;
  const problem::ImpulseTrain impulses(
      {.arrival_rate = rate, .law = "laplace", .intensity = rate * 2 * scale * scale, .mean = 0});
  const BackwardEquationExcitation excitation{.impulse_rate = rate,
                                              .law = &impulses.amplitude_law()};
  const double v = 0.7, exact = (1 + 2 / scale + (4 - v * v) / (2 * scale * scale)) / rate;
  EXPECT_NEAR(mean_time(system_, excitation, level_, 0.4, v, 8, 24), exact, 1e-6);
  EXPECT_NEAR(mean_time(system_, excitation, level_, 1.5, -v, 8, 24), exact, 1e-6);
}

// The area of the ellipse v^2 + y^2 < 2 H is 2 pi H.
TEST(EnergyLevelGrid, HasTheAreaBelowTheLevel) {
  const double level = 0.8;
  for (const double wall : {-10.0, 0.0, -0.6}) {
    const System system({.damping = 0.1, .stiffness = 1}, {.left = wall, .left_restitution = 0.9});
    const problem::Problem transformed = tests::in_wall_coordinates({.name = "", .system = system});
    const problem::EffectivePotential potential(transformed.system);
    const double in_wall = transform::energy_level_in_wall_coordinates(transformed, level);
    const auto interval = problem::UndampedOrbits({.name = "", .system = transformed.system})
                              .half_cycles(in_wall)
                              .front();
    const EnergyLevelGrid grid(transformed.system, potential, interval, in_wall, 24, 24, {});
    const double w = std::sqrt(2 * level), y = std::max(wall, -w);
    // Area on the left of y = 0
    const double left = -y * std::sqrt(w * w - y * y) + w * w * std::asin(-y / w);
    const double exact = std::numbers::pi * level + left;
    EXPECT_NEAR(grid.integration_weights().sum(), exact, 1e-6 * exact) << wall;
  }
}

// For small damping c and D = c H / b, energy averaging gives c T = Ei(b) - ln b - gamma from rest.
TEST(EnergyLevelGrid, HasTheMeanTimeOfEnergyAveragingForWeakDamping) {
  const double level = 0.5, b = 1.7, damping = 0.025;
  const auto scaled_time = [&](const problem::WallParameters& walls) {
    const System system({.damping = damping, .stiffness = 1}, walls);
    const double diffusion = damping * level / b;
    return damping * mean_time(system, {.diffusion = diffusion}, level, 0, 0, 32, 40);
  };
  const double exact = std::expint(b) - std::log(b) - std::numbers::egamma;
  const double without_wall = scaled_time({.none = true});
  EXPECT_NEAR(without_wall, exact, 1e-3 * exact);
  // An elastic wall at the equilibrium does not change the energy.
  EXPECT_NEAR(scaled_time({.left = 0, .left_restitution = 1}), without_wall, 3e-4 * exact);
}

// The order of convergence is about 3 to 4: the error on the coarse grid is more than 10 times the
// error on the grid with twice as many nodes.
TEST(EnergyLevelGrid, ConvergesFasterThanWithOrderTwo) {
  const problem::Problem p = tests::paper_case(1);
  const auto time = [&](int nodes) {
    return mean_time(p.system, {.impulse_rate = 1, .law = &p.impulses.amplitude_law()}, 1, 0, 0,
                     nodes, nodes);
  };
  const double fine = time(48);
  EXPECT_GT(std::abs(time(16) - fine), 6 * std::abs(time(32) - fine));
}

// A growing mode would not change the mean times, but the survival probabilities.
TEST(EnergyLevelGrid, HasNoGrowingModes) {
  const problem::Problem p = tests::paper_case(1);
  for (const problem::WallParameters& walls :
       {problem::WallParameters{.left = 0, .left_restitution = 0.98},
        problem::WallParameters{.none = true}}) {
    const System system({.damping = 0.1, .stiffness = 1, .cubic = 0.1}, walls);
    const problem::EffectivePotential potential(system);
    const auto interval =
        problem::UndampedOrbits({.name = "", .system = system}).half_cycles(1).front();
    const EnergyLevelGrid grid(system, potential, interval, 1, 16, 20,
                               {.impulse_rate = 1, .law = &p.impulses.amplitude_law()});
    const Eigen::MatrixXd matrix = grid.backward_matrix();
    EXPECT_LT(matrix.eigenvalues().real().maxCoeff(), 0) << walls.none;
  }
}

// The mean times and the hazard agree with simulations of 1e7 units of time within two standard
// errors (0.6 % and 0.5 %). The mean from the stationary law is the integral of the survival
// probability.
TEST(EnergyPassage, HasConsistentValuesInCase1) {
  std::vector<double> times;
  constexpr int kIntervals = 100;
  for (int k = 0; k <= kIntervals; ++k) times.push_back(k);
  const FirstPassageResult passage = solve_energy_passage(tests::paper_case(1), {}, 1, times);
  ASSERT_EQ(passage.status, Status::ok) << passage.reason;
  EXPECT_NEAR(passage.hazard->value, 0.0226652, 1e-5);
  EXPECT_NEAR(passage.mean_from_point->value, 49.684, 0.02);
  EXPECT_NEAR(passage.probability_below->value, 0.89904, 3e-4);
  EXPECT_FALSE(passage.rice_rate);
  const auto& survival = passage.survival_from_stationary;
  double integral = survival.back().value / passage.hazard->value;  // of the tail
  for (int k = 0; k < kIntervals; ++k) {
    integral += (survival[k].value + survival[k + 1].value) / 2;
  }
  EXPECT_NEAR(passage.mean_from_stationary->value, integral, 2e-3 * integral);
  const auto& map = passage.mean_passage_times_by_start.value();
  EXPECT_EQ(map.averages.back(), 0);  // above the level
  EXPECT_NEAR(*std::ranges::max_element(map.averages), 49.7, 0.1);
}

TEST(EnergyPassage, RefusesLevelsWithoutAnIntervalBelow) {
  EXPECT_EQ(solve_energy_passage(tests::paper_case(1), {}, -1, {}).status, Status::not_offered);
}

// The value does not change at an impact.
TEST(EnergyLevelGrid, HasEqualTimesBeforeAndAfterAnImpact) {
  const System system({.damping = 0.1, .stiffness = 1}, {.left = 0, .left_restitution = 0.7});
  const auto time = [&](double v) {
    return mean_time(system, {.diffusion = 0.2}, 1, 0, v, 24, 24);
  };
  EXPECT_NEAR(time(-1), time(0.7), 1e-12);
  EXPECT_GT(time(0.7), 1.01 * time(1));
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
