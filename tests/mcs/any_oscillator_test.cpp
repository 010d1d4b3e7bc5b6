#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "mcs/applicability.hpp"
#include "mcs/solve.hpp"
#include "simulate_and_compare.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::mcs {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using tests::expect_within_four_errors;
using tests::gaussian_impulses;
using tests::with_impulses;
using tests::with_noise;

const WallParameters kNoWall{.none = true};

WallParameters left_wall(double at, double r) { return {.left = at, .left_restitution = r}; }

/// Simulates in wall coordinates and returns densities and atoms in physical coordinates. The tests
/// judge L1 errors by standard errors, so the accuracy is low.
SimulationResult simulate_problem(const Problem& problem, double time,
                                  std::optional<double> white_step = {}) {
  SimulationResult result = simulate_stationary_density(
      tests::in_wall_coordinates(problem),
      {.time = time, .accuracy = 0.1, .seed = 20261123, .white_step = white_step});
  result.solution = transform::to_physical_coordinates(problem::wall_frame(problem.system),
                                                       std::move(result.solution));
  return result;
}

void expect_white_noise_law(const Problem& problem, const SimulationResult& result) {
  const exact::EnergyLaw law(problem);
  const auto& m = result.solution.moments;
  const auto& e = result.solution.standard_errors->moments;
  ASSERT_TRUE(result.solution.has_status_ok()) << result.solution.reason;
  expect_within_four_errors(m.y1, law.moment(1, 0), e.y1, "E[y]");
  expect_within_four_errors(m.y2, law.moment(2, 0), e.y2, "E[y^2]");
  expect_within_four_errors(m.y4, law.moment(4, 0), e.y4, "E[y^4]");
  expect_within_four_errors(m.v1, 0, e.v1, "E[v]");
  expect_within_four_errors(m.v2, law.moment(0, 2), e.v2, "E[v^2]");
  expect_within_four_errors(m.v4, law.moment(0, 4), e.v4, "E[v^4]");
  for (const auto& [variable, estimate] : result.solution.estimated_marginals) {
    const bool is_y = variable == transform::StateVariable::y;
    double distance = 0;
    for (std::size_t b = 0; b < estimate.size(); ++b) {
      const double x = estimate.bin_centre(b);
      const double p = is_y ? law.displacement_marginal(x) : law.velocity_marginal(x);
      distance += std::abs(estimate.density[b] - p) * estimate.bin_width(b);
    }
    const auto& sampling = *result.solution.sampling;
    EXPECT_LT(distance, 1.5 * *(is_y ? sampling.y : sampling.ydot) + 2e-3) << is_y;
  }
}

void expect_power_balance(const SimulationResult& result) {
  const auto& [solution, summary] = result;
  expect_within_four_errors(solution.energy_residual, 0, solution.standard_errors->energy_residual,
                            "power");
  expect_within_four_errors(summary.excess_power, 0, summary.excess_power_error, "excess power");
  const auto& [virial, momentum] = summary.balances;
  expect_within_four_errors(*virial, 0, *summary.balance_errors.virial, "virial");
  expect_within_four_errors(*momentum, 0, *summary.balance_errors.momentum, "momentum");
}

TEST(AnyOscillator, UnderWhiteNoiseWithoutLossesHasItsExactLaw) {
  struct Named {
    const char* name;
    System system;
    double intensity;
  };
  const std::vector<Named> list{
      {"no wall", System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, kNoWall), 0.4},
      {"gap", System({.damping = 0.2, .stiffness = 1}, left_wall(-0.5, 1)), 0.4},
      {"preload", System({.damping = 0.2, .stiffness = 1}, left_wall(0.5, 1)), 0.4},
      {"right wall",
       System({.damping = 0.2, .stiffness = 1, .quadratic = 0.2, .cubic = 0.5},
              {.right = 0.3, .right_restitution = 1}),
       0.4},
      {"two walls",
       System({.damping = 0.2, .stiffness = 1},
              {.left = -0.5, .left_restitution = 1, .right = 1, .right_restitution = 1}),
       0.4},
      {"double well", System({.damping = 0.2, .stiffness = -1, .cubic = 1}, kNoWall), 0.2},
      {"quintic", System({.damping = 0.2, .constant = 0.1, .stiffness = -1, .quintic = 1}, kNoWall),
       0.2},
      {"ball", System({.damping = 0.2, .constant = 1, .restitution = 1}), 0.4}};
  for (const auto& [name, system, intensity] : list) {
    SCOPED_TRACE(name);
    const Problem problem = with_noise(system, intensity);
    const SimulationResult result = simulate_problem(problem, 4e4, 0.4);
    expect_white_noise_law(problem, result);
    expect_power_balance(result);
  }
}

// The balance of power is a small difference of large terms. An error of 1e-3 in the rule for one
// of these terms is detected.
TEST(AnyOscillator, OnARingHasCaugheysLaw) {
  const System ring({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, kNoWall);
  const Problem problem = with_noise(ring, 0.4);
  const SimulationResult result = simulate_problem(problem, 4e4);
  expect_white_noise_law(problem, result);
  expect_power_balance(result);
}

TEST(AnyOscillator, IsSimulatedUnderWhiteNoiseInPlaceOfItsImpulses) {
  const Problem problem =
      with_impulses(System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, left_wall(-0.5, 1)),
                    gaussian_impulses(2, 0.3, 0.1));
  const SimulationResult result = simulate_stationary_density(
      tests::in_wall_coordinates(problem), {.equation = DensityEquation::white, .time = 1e5});
  const exact::EnergyLaw law(problem);
  const auto& e = result.solution.standard_errors->moments;
  expect_within_four_errors(result.solution.moments.y1, law.moment(1, 0), e.y1, "E[y]");
  expect_within_four_errors(result.solution.moments.y2, law.moment(2, 0), e.y2, "E[y^2]");
  expect_within_four_errors(result.solution.moments.v4, law.moment(0, 4), e.v4, "E[v^4]");
  expect_power_balance(result);
}

// Under Gaussian and Poisson excitation the cumulants of both responses add.
TEST(AnyOscillator, ThatIsLinearWithoutWallsHasItsExactCumulants) {
  Problem problem = with_impulses(System({.damping = 0.2, .stiffness = 1}, kNoWall),
                                  gaussian_impulses(1, 0.1, 0.1));
  for (const double intensity : {0.0, 0.1}) {
    SCOPED_TRACE(intensity);
    problem.noise.intensity = intensity;
    const SimulationResult result = simulate_problem(problem, 1e5, 0.2);
    const auto& m = result.solution.moments;
    const auto& e = result.solution.standard_errors->moments;
    const auto k = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
    const double mean = k(1, 0), y2 = k(2, 0), v2 = k(0, 2);
    expect_within_four_errors(m.y1, mean, e.y1, "E[y]");
    expect_within_four_errors(m.y2, y2 + mean * mean, e.y2, "E[y^2]");
    expect_within_four_errors(m.v2, v2, e.v2, "E[v^2]");
    expect_within_four_errors(
        m.y4, k(4, 0) + 4 * k(3, 0) * mean + 3 * y2 * y2 + 6 * y2 * mean * mean + std::pow(mean, 4),
        e.y4, "E[y^4]");
    expect_within_four_errors(m.v4, k(0, 4) + 3 * v2 * v2, e.v4, "E[v^4]");
    expect_power_balance(result);
  }
}

// E[v^2] = (lambda E[Y^2] + 2D) / (2c) with constant damping and r = 1, for any spring.
TEST(AnyOscillator, WithoutLossesHasTheMeanSquareVelocityOfItsPower) {
  const std::vector<System> list{
      System({.damping = 0.1, .stiffness = -1, .cubic = 1}, kNoWall),
      System({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 1}),
      System({.damping = 0.1, .stiffness = -1, .quintic = 1},
             {.left = -0.5, .left_restitution = 1, .right = 1, .right_restitution = 1})};
  for (const System& system : list) {
    for (const double intensity : {0.0, 0.05}) {
      SCOPED_TRACE(intensity);
      Problem problem = with_impulses(system, gaussian_impulses(1, 0.05, 0.02));
      problem.noise.intensity = intensity;
      const SimulationResult result = simulate_problem(problem, 4e4);
      expect_within_four_errors(result.solution.moments.v2, (0.05 + intensity) / 0.2,
                                result.solution.standard_errors->moments.v2, "E[v^2]");
      expect_power_balance(result);
    }
  }
}

TEST(AnyOscillator, WithLossesAndAMeanKeepsItsBalances) {
  const System van_der_pol({.damping = -0.2, .van_der_pol = 0.2, .stiffness = 1}, kNoWall);
  const System rayleigh_at_walls(
      {.damping = -0.2, .rayleigh = 0.1, .stiffness = 1, .quintic = 0.1},
      {.left = -1, .left_restitution = 0.9, .right = 1.5, .right_restitution = 0.7});
  const System right({.damping = 0.1, .van_der_pol = 0.1, .stiffness = 1},
                     {.right = 0.4, .right_restitution = 0.6});
  const System stops(
      {.damping = 0.1, .stiffness = -1, .cubic = 1},
      {.left = -0.5, .left_restitution = 0.7, .right = 0.4, .right_restitution = 0.5});
  const System preload({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.5});
  for (const System& system : {van_der_pol, rayleigh_at_walls, right, stops, preload}) {
    for (const double intensity : {0.0, 0.1}) {
      Problem problem = with_impulses(system, gaussian_impulses(1, 0.2, 0.05));
      problem.noise.intensity = intensity;
      SCOPED_TRACE(problem::non_default_parameters_text(problem));
      expect_power_balance(simulate_problem(problem, 2e4));
    }
  }
}

TEST(AnyOscillator, MirroredHasTheMirroredLaw) {
  const Problem left = with_impulses(
      System({.damping = 0.1, .van_der_pol = 0.1, .stiffness = 1, .quadratic = 0.1, .cubic = 0.2},
             left_wall(-0.5, 0.8)),
      gaussian_impulses(1, 0.1, -0.05));
  const Problem right = with_impulses(
      System({.damping = 0.1, .van_der_pol = 0.1, .stiffness = 1, .quadratic = -0.1, .cubic = 0.2},
             {.right = 0.5, .right_restitution = 0.8}),
      gaussian_impulses(1, 0.1, 0.05));
  // A problem with the paper's oscillator and its mirror image.
  const Problem own =
      with_impulses(System({.damping = 0.1, .stiffness = 1, .cubic = 0.1, .restitution = 0.8}),
                    gaussian_impulses(1, 0.1, -0.05));
  const Problem others = with_impulses(System({.damping = 0.1, .stiffness = 1, .cubic = 0.1},
                                              {.right = 0, .right_restitution = 0.8}),
                                       gaussian_impulses(1, 0.1, 0.05));
  for (const auto& [a, b] : {std::pair{left, right}, std::pair{own, others}}) {
    const SimulationResult here = simulate_problem(a, 1e4), there = simulate_problem(b, 1e4);
    const auto &m = here.solution.moments, &n = there.solution.moments;
    EXPECT_NEAR(m.y1, -n.y1, 1e-12);
    EXPECT_NEAR(m.v1, -n.v1, 1e-12);
    EXPECT_NEAR(m.y2, n.y2, 1e-12);
    EXPECT_NEAR(m.y4, n.y4, 1e-12);
    EXPECT_NEAR(m.v4, n.v4, 1e-12);
    const auto& q = here.summary.y_quantiles;
    const auto& p = there.summary.y_quantiles;
    ASSERT_EQ(q.size(), p.size());
    ASSERT_FALSE(q.empty());
    EXPECT_NEAR(q.front().value, -p.back().value, 1e-12);
    EXPECT_NEAR(q.front().probability, 1 - p.back().probability, 1e-12);
    EXPECT_LE(p.front().lower, p.front().upper);
    EXPECT_LT(p.front().value, p.back().value);
    EXPECT_LT(there.summary.crossings.front().level, 0.5);
  }
}

// The rate of upcrossings of a level is int v p(level, v) dv over v > 0, with and without kicks.
TEST(AnyOscillator, PassesLevelsAtTheRateOfItsLaw) {
  const Problem problem =
      with_noise(System({.damping = 0.2, .stiffness = -1, .cubic = 1}, kNoWall), 0.2);
  const SimulationResult result = simulate_problem(problem, 4e4, 0.4);
  const exact::EnergyLaw law(problem);
  const double mean_speed = std::sqrt(0.5 / (2 * std::numbers::pi));  // E[v; v > 0]
  int looked = 0;
  for (const auto& [level, rate] : result.summary.crossings) {
    const double p = law.displacement_marginal(level);
    if (p < 0.05) continue;
    expect_within_four_errors(rate.mean, mean_speed * p, rate.standard_error, "crossings");
    ++looked;
  }
  EXPECT_GT(looked, 3);
  EXPECT_TRUE(result.summary.peaks.empty());
}

// A ball leaves the floor with the speed |Y| or r |Y| and then rests until the next impulse. The
// flight time of the ball is (2/g) (1 + r + ..) times the first speed, so 1 - P0 = lambda E|Y|
// (1+r)/(g (1-r)) as lambda -> 0.
TEST(AnyOscillator, RestsInContactBetweenRareImpulses) {
  const double r = 0.7, rate = 0.01, gravity = 1;
  const Problem problem = with_impulses(
      System({.damping = 0, .constant = gravity, .restitution = r}), gaussian_impulses(rate, rate));
  SimulationOptions options{.time = 2e6, .seed = 20261123};
  for (int k = 0; k <= 50; ++k) {
    options.y_edges.push_back(0.3 * k);
    options.v_edges.push_back(0.24 * (k - 25));
  }
  const SimulationResult result = simulate_stationary_density(problem, options);
  const auto& atom = result.solution.atoms.at(0);
  EXPECT_EQ(result.solution.atoms.size(), 1u);
  EXPECT_EQ(atom.y, 0);
  // Impulses during the flight have an effect of second order in lambda.
  const double aloft = rate * std::sqrt(2 / std::numbers::pi) * (1 + r) / (gravity * (1 - r));
  EXPECT_NEAR(1 - atom.probability, aloft, aloft * aloft + 4 * *atom.standard_error);
  EXPECT_LT(*atom.standard_error, 3e-4);
  EXPECT_NEAR(result.solution.mass, 1, 1e-3);
  EXPECT_LT(result.solution.mass - atom.probability, 0.06);
  EXPECT_TRUE(result.summary.y_quantiles.empty());
  expect_power_balance(result);
  for (const auto& observation : result.solution.metrics) {
    EXPECT_NE(observation.path, "impact_rate");  // the rate is infinite
  }
}

TEST(AnyOscillator, RestsAtBothStopsOfADoubleWellAlike) {
  const Problem problem = with_impulses(
      System({.damping = 0.1, .stiffness = -1, .cubic = 1},
             {.left = -0.5, .left_restitution = 0.5, .right = 0.5, .right_restitution = 0.5}),
      gaussian_impulses(1, 0.1));
  const auto result = simulate_problem(problem, 1e5);
  const auto& atoms = result.solution.atoms;
  ASSERT_EQ(atoms.size(), 2u);
  EXPECT_EQ(atoms[0].y, -0.5);
  EXPECT_EQ(atoms[1].y, 0.5);
  EXPECT_GT(atoms[0].probability, 20 * *atoms[0].standard_error);
  expect_within_four_errors(atoms[0].probability, atoms[1].probability,
                            std::hypot(*atoms[0].standard_error, *atoms[1].standard_error), "P0");
  EXPECT_NEAR(result.solution.mass, 1, 1e-4);
  // Gaussian noise removes the atoms.
  Problem noisy = problem;
  noisy.noise.intensity = 1e-3;
  const auto moving = simulate_problem(noisy, 5e2);
  EXPECT_TRUE(moving.solution.atoms.empty());
  EXPECT_NEAR(moving.solution.mass, 1, 1e-4);
}

// The kick intervals decrease near the wall. With fixed intervals the strength of the kicks would
// limit how near to rest the mass comes.
TEST(AnyOscillator, UnderNoiseAtAWallWithLossesDoesNotDependOnTheKicks) {
  const Problem gap =
      with_noise(System({.damping = 0.1, .stiffness = 1}, left_wall(-0.5, 0.5)), 0.1);
  const Problem pressed = with_noise(
      System({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.5}), 0.3);
  for (const Problem& problem : {gap, pressed}) {
    const SimulationResult coarse = simulate_problem(problem, 8e4, 0.4),
                           fine = simulate_problem(problem, 4e4, 0.1);
    const auto &m = coarse.solution.moments, &n = fine.solution.moments;
    const auto &e = coarse.solution.standard_errors->moments,
               &f = fine.solution.standard_errors->moments;
    expect_within_four_errors(m.y1, n.y1, std::hypot(e.y1, f.y1), "E[y]");
    expect_within_four_errors(m.v2, n.v2, std::hypot(e.v2, f.v2), "E[v^2]");
    expect_within_four_errors(m.v4, n.v4, std::hypot(e.v4, f.v4), "E[v^4]");
  }
}

// The averaged law gives the initial masses of the wells. Transitions are rare, so the status
// reports that the masses are still the initial ones.
TEST(AnyOscillator, WithRareTransitionsIsNotConverged) {
  const Problem problem =
      with_noise(System({.damping = 0.2, .stiffness = -1, .cubic = 1}, kNoWall), 0.006);
  const auto solution = simulate_problem(problem, 1e4).solution;
  EXPECT_EQ(solution.status, transform::Status::not_converged);
  EXPECT_NE(solution.reason.find("wells"), std::string::npos) << solution.reason;
  // Both wells have equal initial masses.
  EXPECT_NEAR(solution.moments.y1, 0, 4 * solution.standard_errors->moments.y1);
  EXPECT_GT(solution.standard_errors->moments.y1, 0.02);
}

TEST(AnyOscillator, IsNotSupportedWhereImpactsAccumulateUnderNoise) {
  const Problem gap = tests::in_wall_coordinates(with_impulses(
      System({.damping = 0.1, .stiffness = 1}, left_wall(-0.5, 0.1)), gaussian_impulses(1, 0.1)));
  EXPECT_EQ(unsupported_reason(gap, {}), "");
  EXPECT_NE(
      unsupported_reason(gap, {.equation = DensityEquation::white}).find("inelastic collapse"),
      std::string::npos);
  Problem noisy = gap;
  noisy.noise.intensity = 0.1;
  EXPECT_NE(unsupported_reason(noisy, {}).find("inelastic collapse"), std::string::npos);
  EXPECT_EQ(simulate_stationary_density(noisy, {.time = 1e3}).solution.status,
            transform::Status::failed);
}

TEST(AnyOscillator, DoesNotDependOnThreadsAndGoesOnFromACheckpoint) {
  Problem problem = with_impulses(System({.damping = 0.1, .constant = 0.3, .stiffness = 1},
                                         {.right = 0.2, .right_restitution = 0.6}),
                                  gaussian_impulses(1, 0.1));
  for (const double intensity : {0.0, 0.05}) {
    problem.noise.intensity = intensity;
    const Problem seen = tests::in_wall_coordinates(problem);
    const SimulationResult one =
        simulate_stationary_density(seen, {.time = 1e4, .threads = 1, .streams = 20});
    const SimulationResult three =
        simulate_stationary_density(seen, {.time = 1e4, .threads = 3, .streams = 20});
    EXPECT_EQ(one.solution.moments.y4, three.solution.moments.y4);
    const std::string file = testing::TempDir() + "fpkcheck_any_oscillator";
    int rounds = 0;
    simulate_stationary_density(seen, {.time = 1e4, .streams = 20, .checkpoint = file, .stop = [&] {
                                         return ++rounds == 3;
                                       }});
    const SimulationResult resumed =
        simulate_stationary_density(seen, {.time = 1e4, .streams = 20, .resume = file});
    EXPECT_EQ(one.solution.moments.y4, resumed.solution.moments.y4);
    EXPECT_EQ(one.solution.moments.v2, resumed.solution.moments.v2);
    EXPECT_EQ(one.solution.mass, resumed.solution.mass);
    EXPECT_EQ(one.summary.excess_power, resumed.summary.excess_power);
    // The checkpoint of another noise intensity is refused.
    Problem other = problem;
    other.noise.intensity = 0.06;
    EXPECT_THROW(simulate_stationary_density(tests::in_wall_coordinates(other),
                                             {.time = 1e4, .streams = 20, .resume = file}),
                 InputError);
    std::remove(file.c_str());
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
