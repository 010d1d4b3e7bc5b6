#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "general_oscillators.hpp"
#include "mcs/applicability.hpp"
#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/motion/multiplicative_kick.hpp"
#include "mcs/motion/taylor_flight.hpp"
#include "mcs/simulation/checkpoint.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "mcs/solve.hpp"
#include "problem/case_file.hpp"
#include "problem/motion_scales.hpp"
#include "simulate_and_compare.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::mcs::formulas {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using tests::expect_within_four_errors;
using tests::gaussian_impulses;
using tests::with_impulses;
using tests::with_noise;

const WallParameters kNoWall{.none = true};

System system_with_formula(const std::string& force, const WallParameters& walls = kNoWall) {
  return System({.force = force}, walls);
}

SimulationResult simulate_problem(const Problem& problem, double time, double step = 0.9) {
  return simulate_stationary_density(tests::in_wall_coordinates(problem),
                                     {.time = time, .accuracy = 1, .seed = 20261126, .step = step});
}

/// Group of streams that receive no impulses.
struct FreeStreams {
  const System& system;
  BinFinder y{tests::uniform_edges(-4, 4, 50)}, v{tests::uniform_edges(-5, 5, 50)};
  StreamMotionParameters motion;
  std::deque<TrajectoryStream> streams{};

  FreeStreams(const Problem& problem, const std::vector<OscillatorState>& starts, double step = 0.9,
              const NoiseKicks& kicks = {})
      : system(problem.system),
        motion{.oscillator = make_oscillator(problem, problem::motion_scales(problem)),
               .kicks = kicks,
               .step = step,
               .sampling_interval = 0.25,
               .y_bins = &y,
               .v_bins = &v} {
    for (const OscillatorState& start : starts) {
      const auto number = static_cast<std::uint32_t>(streams.size());
      streams.push_back({.branch = {.y = start.y,
                                    .v = start.v,
                                    .time_to_impulse = std::numeric_limits<double>::infinity(),
                                    .amplitude = 0,
                                    .time_to_sample = 0.125,
                                    .remaining = 0},
                         .source = ImpulseSource(problem.impulses, 1, number),
                         .record = TrajectoryStreamStatistics(y, v),
                         .noise = NoiseSource(1, number)});
      if (kicks.is_acting()) {
        streams.back().branch.kick_interval = kicks.longest_interval;
        streams.back().branch.time_to_kick = kicks.longest_interval / 2;
      }
    }
  }
  FreeStreams(const FreeStreams&) = delete;

  void advance(double time,
               const simd::SimdVariant& lanes = simd::available_simd_variants().back()) {
    std::vector<TrajectoryStream*> pointers;
    for (TrajectoryStream& stream : streams) pointers.push_back(&stream);
    mcs::advance_all_streams(motion, pointers, time, lanes);
  }
};

const Problem kPolynomial = with_impulses(
    System({.damping = 0.1, .stiffness = 1, .cubic = 0.1}, kNoWall), gaussian_impulses(1, 0.5));
const Problem kSameFormula =
    with_impulses(system_with_formula("0.1*v + y + 0.1*y^3 + 0*abs(y)"), gaussian_impulses(1, 0.5));
const std::vector<OscillatorState> kStarts{{0.3, 0.9}, {-1.5, 0}, {0, 2.5}, {3, -1}};

double distance(const TrajectoryBranch& a, const TrajectoryBranch& b) {
  return std::hypot(a.y - b.y, a.v - b.v);
}

TEST(Formula, HasTheTrajectoriesOfItsPolynomial) {
  FreeStreams exact(kPolynomial, kStarts, 0.5), integrated(kSameFormula, kStarts);
  exact.advance(20);
  integrated.advance(20);
  for (std::size_t s = 0; s < kStarts.size(); ++s) {
    EXPECT_LT(distance(exact.streams[s].branch, integrated.streams[s].branch), 1e-6) << s;
  }
}

// The tolerance of a step is proportional to phase^5, and the error of a trajectory to phase^5 too.
TEST(Formula, TrajectoriesConvergeWithTheOrderOfTheMethod) {
  const Problem smooth =
      with_impulses(system_with_formula("0.1*v + tanh(y) + y"), gaussian_impulses(1, 0.5));
  const auto end = [&](double step) {
    FreeStreams free(smooth, {{1.2, 1.9}}, step);
    free.advance(20);
    return free.streams[0].branch;
  };
  const TrajectoryBranch fine = end(0.1125);
  const double order = std::log2(distance(end(0.9), fine) / distance(end(0.45), fine));
  EXPECT_GT(order, 3.8);
  EXPECT_LT(order, 6.5);
}

TEST(Formula, HasTheMomentsOfItsPolynomial) {
  const WallParameters wall{.left = -0.5, .left_restitution = 0.8};
  const Problem gap = with_impulses(System({.damping = 0.1, .stiffness = 1, .cubic = 0.1}, wall),
                                    gaussian_impulses(1, 0.5));
  const Problem same = with_impulses(system_with_formula("0.1*v + y + 0.1*y^3 + 0*abs(y)", wall),
                                     gaussian_impulses(1, 0.5));
  for (const auto& [a, b] : {std::pair{kPolynomial, kSameFormula}, std::pair{gap, same}}) {
    const SimulationResult polynomial = simulate_problem(a, 3e4),
                           integrated = simulate_problem(b, 3e4);
    const auto &m = polynomial.solution.moments, &n = integrated.solution.moments;
    const auto& e = polynomial.solution.standard_errors->moments;
    // The simulations have the same impulses.
    expect_within_four_errors(n.y1, m.y1, e.y1, "E[y]");
    expect_within_four_errors(n.y2, m.y2, e.y2, "E[y^2]");
    expect_within_four_errors(n.v2, m.v2, e.v2, "E[v^2]");
    expect_within_four_errors(n.v4, m.v4, e.v4, "E[v^4]");
    expect_within_four_errors(integrated.summary.impact_rate.mean,
                              polynomial.summary.impact_rate.mean,
                              polynomial.summary.impact_rate.standard_error + 1e-12, "impacts");
  }
}

TEST(Formula, RestsInContactAsItsPolynomialDoes) {
  const WallParameters wall{.left = 0.5, .left_restitution = 0.5};
  const Problem a =
      with_impulses(System({.damping = 0.1, .stiffness = 1}, wall), gaussian_impulses(1, 0.2));
  const Problem b =
      with_impulses(system_with_formula("0.1*v + y + 0*abs(y)", wall), gaussian_impulses(1, 0.2));
  const SimulationResult polynomial = simulate_problem(a, 3e4),
                         integrated = simulate_problem(b, 3e4);
  ASSERT_EQ(integrated.solution.atoms.size(), 1u);
  expect_within_four_errors(integrated.solution.atoms[0].probability,
                            polynomial.solution.atoms[0].probability,
                            *polynomial.solution.atoms[0].standard_error, "atom");
  expect_within_four_errors(*integrated.summary.balances.momentum, 0,
                            *integrated.summary.balance_errors.momentum, "momentum");
  expect_within_four_errors(*integrated.summary.balances.virial, 0,
                            *integrated.summary.balance_errors.virial, "virial");
}

TEST(Formula, MomentsDoNotDependOnTheStep) {
  for (const char* force : {"0.1*v + y + 4*max(y-0.5,0)", "0.2*v*abs(v) + y + 0.1*y^3",
                            "0.1*v + 0.05*tanh(20*v) + y", "0.1*v + y - 50*max(-y,0)^1.5"}) {
    const Problem problem = with_impulses(system_with_formula(force), gaussian_impulses(1, 0.5));
    const auto coarse = simulate_problem(problem, 1e4).solution.moments,
               fine = simulate_problem(problem, 1e4, 0.45).solution.moments;
    EXPECT_NEAR(coarse.y2 / fine.y2, 1, 1e-5) << force;
    EXPECT_NEAR(coarse.v2 / fine.v2, 1, 1e-5) << force;
  }
}

void expect_power_balance(const SimulationResult& result) {
  const auto& [solution, summary] = result;
  expect_within_four_errors(solution.energy_residual, 0, solution.standard_errors->energy_residual,
                            "power");
  expect_within_four_errors(*summary.balances.virial, 0, *summary.balance_errors.virial, "virial");
  expect_within_four_errors(*summary.balances.momentum, 0, *summary.balance_errors.momentum,
                            "momentum");
}

// Without walls E[v f] = I/2, hence E[v^2] = I/(2 c) for linear damping.
TEST(Formula, UnderImpulsesHasTheExactBalances) {
  const Problem spring =
      with_impulses(system_with_formula("0.1*v + y + 4*max(y-0.5,0)"), gaussian_impulses(1, 0.2));
  const SimulationResult result = simulate_problem(spring, 1e5);
  expect_within_four_errors(result.solution.moments.v2, 1,
                            result.solution.standard_errors->moments.v2, "E[v^2]");
  expect_power_balance(result);
  expect_power_balance(simulate_problem(
      with_impulses(system_with_formula("0.2*v*abs(v) + y + 0.1*y^3"), gaussian_impulses(1, 0.5)),
      3e4));
  // The problem has a mirrored frame and impulses with a nonzero mean.
  expect_power_balance(simulate_problem(
      with_impulses(system_with_formula("0.1*v + 0.1*tanh(5*v) + y + 0.2*max(y,0)^1.5",
                                        {.right = 0.3, .right_restitution = 0.8}),
                    gaussian_impulses(1, 0.3, 0.1)),
      3e4));
}

// E[v^2] = D/c for linear damping and any spring, also with an elastic wall.
TEST(Formula, UnderWhiteNoiseHasTheExactMeanKineticEnergy) {
  const WallParameters wall{.left = -0.5, .left_restitution = 1};
  for (const Problem& problem : {with_noise(system_with_formula("0.2*v + 2*tanh(y)"), 0.4),
                                 with_noise(system_with_formula("0.2*v + sinh(y)"), 0.4),
                                 with_noise(system_with_formula("0.2*v + sinh(y)", wall), 0.4)}) {
    const SimulationResult result = simulate_problem(problem, 6e4);
    const auto& e = result.solution.standard_errors->moments;
    expect_within_four_errors(result.solution.moments.v2, 1, e.v2, "E[v^2]");
    expect_within_four_errors(result.solution.moments.v4, 3, e.v4, "E[v^4]");
    expect_power_balance(result);
  }
}

// Dry friction: the balance of power is mu_c E[|v|] = D.
TEST(Formula, UnderWhiteNoiseMayHaveJumps) {
  const Problem friction = with_noise(system_with_formula("0.2*sign(v) + y"), 0.2);
  EXPECT_EQ(unsupported_reason(friction, {}), "");
  expect_power_balance(simulate_problem(friction, 3e4));
  // Kicks at the usual interval smooth the kink of the density: E[y^2] would be 3e-3 too large.
  const auto kick_interval = [&](const SimulationOptions& options) {
    return make_simulation_plan(friction, options).kicks.longest_interval;
  };
  EXPECT_EQ(kick_interval({}), kick_interval({.white_step = 0.05}));
}

TEST(Formula, GivesTheSameBitsForAnyWidthAndInstructions) {
  const Problem problem = tests::in_wall_coordinates(with_impulses(
      system_with_formula(
          "0.1*v + 0.05*tanh(20*v) + y + 0.1*exp(-y) + 0.1*sin(y) + max(y,0)^1.3",
          {.left = -0.3, .left_restitution = 0.8, .right = 1.2, .right_restitution = 0.7}),
      gaussian_impulses(1, 0.5)));
  std::vector<OscillatorState> starts;
  for (int s = 0; s < 11; ++s) starts.push_back({0.1 * s, 1 - 0.2 * s});
  const NoiseKicks noise{
      .diffusion = 0.1, .longest_interval = 0.2, .shortest_interval = 1e-5, .has_lossy_wall = true};
  for (const auto& kicks : {NoiseKicks{}, noise}) {
    FreeStreams reference(problem, starts, 0.9, kicks);
    reference.advance(50, {simd::InstructionSet::baseline, 1});
    for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
      SCOPED_TRACE(lanes.width);
      FreeStreams group(problem, starts, 0.9, kicks);
      group.advance(50, lanes);
      for (std::size_t s = 0; s < starts.size(); ++s) {
        const TrajectoryStream &a = reference.streams[s], &b = group.streams[s];
        EXPECT_EQ(a.branch.y, b.branch.y);
        EXPECT_EQ(a.branch.v, b.branch.v);
        EXPECT_EQ(a.record.powers, b.record.powers);
        EXPECT_EQ(a.record.force_v, b.record.force_v);
        EXPECT_EQ(a.record.histogram.histogram_cell_weights(),
                  b.record.histogram.histogram_cell_weights());
        EXPECT_EQ(a.record.flights, b.record.flights);
      }
    }
  }
}

TEST(Formula, ResumesFromACheckpointOfTheSameFormulaOnly) {
  const std::string file = testing::TempDir() + "fpkcheck_formula";
  const auto problem = [](const char* force) {
    return with_impulses(system_with_formula(force), gaussian_impulses(1, 0.5));
  };
  const Problem one = problem("0.1*v + sinh(y)"), other = problem("0.1*v + sinh(1.1*y)");
  const SimulationOptions whole{.time = 1e4, .accuracy = 1, .streams = 20};
  SimulationOptions first = whole, second = whole;
  int rounds = 0;
  first.checkpoint = second.resume = file;
  first.stop = [&] { return ++rounds == 3; };
  simulate_stationary_density(one, first);
  EXPECT_EQ(simulate_stationary_density(one, second).solution.moments.y4,
            simulate_stationary_density(one, whole).solution.moments.y4);
  EXPECT_ANY_THROW(simulate_stationary_density(other, second));
  std::remove(file.c_str());
}

TEST(Formula, IsRefusedWithAReasonWhereItIsNotSupported) {
  const Problem friction =
      with_impulses(system_with_formula("0.2*sign(v) + y"), gaussian_impulses(1, 0.5));
  EXPECT_NE(unsupported_reason(friction, {}).find("tanh(v/eps)"), std::string::npos);
  EXPECT_EQ(unsupported_reason(friction, {.equation = DensityEquation::white}), "");
  EXPECT_EQ(unsupported_reason(kSameFormula, {}), "");
  EXPECT_NE(unsupported_reason(kSameFormula, {.tails = true}).find("formula"), std::string::npos);
}

// sqrt(y) is undefined behind the wall, where trial states of a step lie.
TEST(Formula, NeedNotExistBeyondTheWall) {
  const Problem problem = with_impulses(
      system_with_formula("0.1*v + y + sqrt(y)", {.left = 0, .left_restitution = 0.8}),
      gaussian_impulses(1, 0.5));
  const SimulationResult result = simulate_problem(problem, 1e4);
  ASSERT_TRUE(result.solution.has_status_ok()) << result.solution.reason;
  expect_power_balance(result);
}

Problem problem_of_case_text(const std::string& ini) {
  std::istringstream file(ini);
  return problem::read_case(file, "test", "test.ini");
}

Problem problem_with_noise_factor(const std::string& force, const std::string& factor,
                                  const char* interpretation,
                                  const std::string& walls = "none = true",
                                  const std::string& impulses = "") {
  const std::string sense = *interpretation == '\0'
                                ? std::string()
                                : "interpretation = " + std::string(interpretation) + '\n';
  return problem_of_case_text("[system]\nforce = " + force + "\n[wall]\n" + walls +
                              "\n[noise]\nintensity = 0.2\nfactor = " + factor + '\n' + sense +
                              impulses);
}

const std::string kEnergyForce = "0.1*v + 0.05*v*(y^2+v^2) + y",
                  kEnergyFactor = "sqrt(1+0.25*(y^2+v^2))",
                  kImpulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.2\nmean = 0\n";

struct ExactMoments {
  double y2, y4, v2, v4;
};

void expect_moments(const SimulationResult& result, const ExactMoments& exact) {
  const auto& m = result.solution.moments;
  const auto& e = result.solution.standard_errors->moments;
  expect_within_four_errors(m.y2, exact.y2, e.y2, "E[y^2]");
  expect_within_four_errors(m.y4, exact.y4, e.y4, "E[y^4]");
  expect_within_four_errors(m.v2, exact.v2, e.v2, "E[v^2]");
  expect_within_four_errors(m.v4, exact.v4, e.v4, "E[v^4]");
}

// Caughey and Ma: with damping v d(H) and G = 1 + H/2, d = (1 + H)/10, D = 1/10 the law is
// C (1 + H/2) exp(-2 H) in Ito's sense and C (1 + H/2)^(3/2) exp(-2 H) in Stratonovich's. The
// moments are E[y^2] = E[H], E[y^4] = 3/2 E[H^2].
TEST(MultiplicativeNoise, HasTheExactLawOfEachSense) {
  const SimulationResult ito = simulate_problem(
                             problem_with_noise_factor(kEnergyForce, kEnergyFactor, "ito"), 1e5),
                         other = simulate_problem(
                             problem_with_noise_factor(kEnergyForce, kEnergyFactor, "stratonovich"),
                             1e5);
  expect_moments(ito, {.y2 = 0.6, .y4 = 1.05, .v2 = 0.6, .v4 = 1.05});
  expect_moments(other, {.y2 = 0.660996, .y4 = 1.25213, .v2 = 0.660996, .v4 = 1.25213});
  expect_power_balance(ito);
  expect_power_balance(other);
  // The difference between the senses exceeds all standard errors.
  EXPECT_GT(other.solution.moments.y2 - ito.solution.moments.y2,
            10 * ito.solution.standard_errors->moments.y2);
}

// With g = g(y) and f = c v g^2 + V' the law is C exp(-c H/D).
TEST(MultiplicativeNoise, OfADisplacementHasItsExactLaw) {
  const SimulationResult polynomial = simulate_problem(
      problem_with_noise_factor("0.2*v*(1+y^2) + y + 0.1*y^3", "sqrt(1+y^2)", ""), 1e5);
  const auto& m = polynomial.solution.moments;
  const auto& e = polynomial.solution.standard_errors->moments;
  expect_within_four_errors(m.y2, 0.444353, e.y2, "E[y^2]");
  expect_within_four_errors(m.v2, 0.5, e.v2, "E[v^2]");
  expect_within_four_errors(m.v4, 0.75, e.v4, "E[v^4]");
  expect_power_balance(polynomial);
  // The problem has a steep step of g, a formula of the force, an elastic wall and a mirrored
  // frame.
  const SimulationResult step = simulate_problem(
      problem_with_noise_factor("0.2*v*(1+0.8*tanh(10*y))^2 + sinh(y)", "1+0.8*tanh(10*y)",
                                "stratonovich", "right = 0.5\nright_restitution = 1"),
      1e5);
  expect_within_four_errors(step.solution.moments.v2, 0.5,
                            step.solution.standard_errors->moments.v2, "E[v^2]");
  expect_within_four_errors(step.solution.moments.v4, 0.75,
                            step.solution.standard_errors->moments.v4, "E[v^4]");
  expect_power_balance(step);
}

// The error of the splitting is of second order in the interval between kicks.
TEST(MultiplicativeNoise, ErrorOfTheSplittingDecreases) {
  const Problem problem = problem_with_noise_factor(kEnergyForce, kEnergyFactor, "ito");
  double stated = 0;  // error estimate of the last simulation
  const auto v4 = [&](double white_step) {
    const SimulationResult result = simulate_stationary_density(
        problem, {.time = 1e6, .accuracy = 1, .seed = 20261126, .white_step = white_step});
    stated = result.solution.error->moments.v4;
    return MeanEstimate{result.solution.moments.v4, result.solution.standard_errors->moments.v4};
  };
  const MeanEstimate coarse = v4(0.5);
  const double stated_coarse = stated;
  const MeanEstimate fine = v4(0.2);
  EXPECT_GT(coarse.mean - 1.05, 3 * coarse.standard_error);
  // The error of the shorter interval is a sixth of the error of the longer.
  EXPECT_NEAR(fine.mean - 1.05, (coarse.mean - 1.05) * 0.16,
              4 * std::hypot(fine.standard_error, 0.16 * coarse.standard_error));
  // With the factor 1 of the first order the statement would be three times as large.
  EXPECT_NEAR(stated_coarse / (coarse.mean - 1.05), 1, 0.6);
}

// The flow of dv/ds = sqrt(1 + v^2) is v = sinh(s + asinh v).
TEST(MultiplicativeNoise, KicksFollowTheFlowOfTheFactor) {
  const problem::NoiseFactor factor("sqrt(1+v^2)", {});
  double y[8] = {}, v[8], start[8], s[8], g[8];
  for (int i = 0; i < 8; ++i) {
    v[i] = start[i] = i - 3.5;
    s[i] = 0.6 * (i % 2 == 0 ? 1 : -1) * (i + 1);
  }
  advance_along_noise_flow(factor, 8, y, v, s, 1, g);
  for (int i = 0; i < 8; ++i) {
    const double exact = std::sinh(s[i] + std::asinh(start[i]));
    EXPECT_NEAR(v[i], exact, 2e-6 * std::cosh(s[i] + std::asinh(start[i]))) << i;
    EXPECT_NEAR(g[i], std::hypot(1, start[i]), 1e-14);
  }
}

// The formula of a constant factor gives the law of additive noise, also with impulses and losses.
TEST(MultiplicativeNoise, OfAConstantFactorIsAdditive) {
  const std::string wall = "left = -0.3\nleft_restitution = 0.7";
  const Problem constant = problem_with_noise_factor("0.1*v + y + 0.1*y^3", "1 + 0*v", "ito", wall,
                                                     kImpulses),
                additive = problem_of_case_text("[system]\nforce = 0.1*v + y + 0.1*y^3\n[wall]\n" +
                                                wall + "\n[noise]\nintensity = 0.2\n" + kImpulses);
  const SimulationResult a = simulate_problem(constant, 3e4), b = simulate_problem(additive, 3e4);
  const auto &m = a.solution.moments, &n = b.solution.moments;
  const auto &e = a.solution.standard_errors->moments, &f = b.solution.standard_errors->moments;
  expect_within_four_errors(m.y2, n.y2, std::hypot(e.y2, f.y2), "E[y^2]");
  expect_within_four_errors(m.v2, n.v2, std::hypot(e.v2, f.v2), "E[v^2]");
  expect_within_four_errors(m.v4, n.v4, std::hypot(e.v4, f.v4), "E[v^4]");
  expect_power_balance(a);
}

TEST(MultiplicativeNoise, WithImpulsesAndLossesHasTheExactBalances) {
  for (const char* sense : {"ito", "stratonovich"}) {
    expect_power_balance(simulate_problem(
        problem_with_noise_factor("0.2*v + 0.3*v*abs(v) + y",
                                  "sqrt(0.5+v^2/(1+v^2)+0.3*sin(y)+0.2*tanh(v))", sense,
                                  "right = 0.4\nright_restitution = 0.9 - 0.2*min(1,v)", kImpulses),
        1e5));
  }
}

TEST(MultiplicativeNoise, GivesTheSameBitsForAnyWidthAndInstructions) {
  const Problem problem = tests::in_wall_coordinates(
      problem_with_noise_factor("0.1*v + sinh(y)", "sqrt(1+0.2*y^2+0.3*v^2)", "ito",
                                "left = -0.3\nleft_restitution = 1 - 0.3*min(1,v)^0.2"));
  std::vector<OscillatorState> starts;
  for (int s = 0; s < 11; ++s) starts.push_back({0.1 * s, 1 - 0.2 * s});
  const NoiseKicks kicks = make_noise_kicks(problem, problem::motion_scales(problem), 0.1, 0.2);
  FreeStreams reference(problem, starts, 0.9, kicks);
  reference.advance(50, {simd::InstructionSet::baseline, 1});
  for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
    SCOPED_TRACE(lanes.width);
    FreeStreams group(problem, starts, 0.9, kicks);
    group.advance(50, lanes);
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const TrajectoryStream &a = reference.streams[s], &b = group.streams[s];
      EXPECT_EQ(a.branch.y, b.branch.y);
      EXPECT_EQ(a.branch.v, b.branch.v);
      EXPECT_EQ(a.record.powers, b.record.powers);
      EXPECT_EQ(a.record.force_v, b.record.force_v);
      EXPECT_EQ(a.record.noise_factor, b.record.noise_factor);
      EXPECT_EQ(a.record.left_wall_squared_impact_speeds, b.record.left_wall_squared_impact_speeds);
      EXPECT_EQ(a.record.work, b.record.work);
    }
  }
}

TEST(MultiplicativeNoise, ResumesFromACheckpointOfTheSameFactorAndSenseOnly) {
  const std::string file = testing::TempDir() + "fpkcheck_factor";
  const Problem one = problem_with_noise_factor(kEnergyForce, kEnergyFactor, "ito"),
                other = problem_with_noise_factor(kEnergyForce, kEnergyFactor, "stratonovich"),
                another = problem_with_noise_factor(kEnergyForce, "sqrt(1+0.24*(y^2+v^2))", "ito");
  // The fingerprint also contains the burn-in and the bins, which depend on the factor.
  const SimulationOptions options{.time = 1e4, .accuracy = 1, .streams = 20};
  const SimulationPlan plan = make_simulation_plan(one, options);
  const std::string print = simulation_fingerprint(one, plan, nullptr);
  EXPECT_NE(print, simulation_fingerprint(other, plan, nullptr));
  EXPECT_NE(print, simulation_fingerprint(another, plan, nullptr));
  SimulationOptions first = options, second = options;
  int rounds = 0;
  first.checkpoint = second.resume = file;
  first.stop = [&] { return ++rounds == 3; };
  simulate_stationary_density(one, first);
  EXPECT_EQ(simulate_stationary_density(one, second).solution.energy_residual,
            simulate_stationary_density(one, options).solution.energy_residual);
  EXPECT_ANY_THROW(simulate_stationary_density(other, second));
  std::remove(file.c_str());
}

TEST(MultiplicativeNoise, IsRefusedWithAReasonWhereItIsNotSupported) {
  const Problem noise = problem_with_noise_factor(kEnergyForce, kEnergyFactor, "ito");
  EXPECT_EQ(unsupported_reason(noise, {}), "");
  EXPECT_NE(unsupported_reason(noise, {.tails = true}), "");
  EXPECT_THROW(simulate_stationary_density(noise, {.tails = true}), InputError);
  const Problem both =
      problem_with_noise_factor(kEnergyForce, kEnergyFactor, "ito", "none = true", kImpulses);
  EXPECT_EQ(unsupported_reason(both, {}), "");
  EXPECT_NE(unsupported_reason(both, {.equation = DensityEquation::white}).find("noise.factor"),
            std::string::npos);
  EXPECT_NE(unsupported_reason(problem_with_noise_factor(kEnergyForce, "1+0.5*sign(v)", "ito"), {})
                .find("tanh"),
            std::string::npos);
}

Problem problem_with_impulse_factor(const std::string& factor, const std::string& system,
                                    const std::string& walls = "none = true",
                                    const std::string& law = "gaussian") {
  return problem_of_case_text("[system]\n" + system + "\n[wall]\n" + walls +
                              "\n[impulse]\nrate = 1\nlaw = " + law +
                              "\nintensity = 0.5\nfactor = " + factor + '\n');
}
const std::string kLinear = "damping = 0.5\nstiffness = 1";

// For y'' + c y' + k y and b = 1 + e y: E[y^2] = I / (2 c k - I e^2), E[v^2] = k E[y^2] for any
// law.
TEST(ParametricImpulses, HaveTheExactMomentsOfALinearOscillator) {
  const double exact = 0.5 / (1 - 0.5 * 0.16);
  for (const char* law : {"gaussian", "exponential", "two_point"}) {
    SCOPED_TRACE(law);
    // A polynomial force and the same force as a formula have different flights.
    for (const std::string& system : {kLinear, std::string("force = 0.5*v + y + 0*abs(y)")}) {
      const SimulationResult result = simulate_problem(
          problem_with_impulse_factor("1 - 0.4*y", system, "none = true", law), 1e5);
      const auto& m = result.solution.moments;
      const auto& e = result.solution.standard_errors->moments;
      expect_within_four_errors(m.y2, exact, e.y2, "E[y^2]");
      expect_within_four_errors(m.v2, exact, e.v2, "E[v^2]");
      expect_power_balance(result);
    }
  }
}

// The weights of the streams assume the expected work of the impulses.
TEST(ParametricImpulses, HaveTheExactBalancesAtWalls) {
  const SimulationResult result =
      simulate_problem(problem_with_impulse_factor(
                           "0.6 + tanh(y)", "force = 0.2*v*abs(v) + sinh(y)",
                           "right = 0.4\nright_restitution = 0.9 - 0.2*min(1,v)", "exponential"),
                       1e5);
  expect_power_balance(result);
  EXPECT_LT(std::abs(result.summary.excess_power), 4 * result.summary.excess_power_error);
}

TEST(ParametricImpulses, ResumeFromACheckpointOfTheSameFactorOnly) {
  const SimulationOptions options{.time = 1e4, .accuracy = 1, .streams = 20};
  const Problem one = problem_with_impulse_factor("1 + 0.4*y", kLinear),
                other = problem_with_impulse_factor("1 - 0.4*y", kLinear);
  const SimulationPlan plan = make_simulation_plan(one, options);
  EXPECT_NE(simulation_fingerprint(one, plan, nullptr),
            simulation_fingerprint(other, plan, nullptr));
}

TEST(ParametricImpulses, AreRefusedWithAReasonWhereTheyAreNotSupported) {
  const Problem problem = problem_with_impulse_factor("1 + 0.4*y", kLinear);
  EXPECT_EQ(unsupported_reason(problem, {}), "");
  EXPECT_NE(
      unsupported_reason(problem, {.equation = DensityEquation::white}).find("impulse.factor"),
      std::string::npos);
  EXPECT_NE(unsupported_reason(problem, {.tails = true}).find("impulse.factor"), std::string::npos);
}

const std::string kViscoelastic = "left = 0\nleft_restitution = 1 - 0.3*min(1,abs(v))^0.2";

Problem problem_with_walls(const std::string& force, const std::string& walls) {
  return problem_of_case_text("[system]\nforce = " + force + "\n[wall]\n" + walls + '\n' +
                              kImpulses);
}

// The reference value comes from finite volumes (`fpkcheck fd`), with an error estimate of 4e-6.
TEST(RestitutionFormula, HasTheMomentsOfFiniteVolumes) {
  const SimulationResult result =
      simulate_problem(problem_with_walls("0.1*v + y", kViscoelastic), 1e6);
  expect_within_four_errors(result.solution.moments.y2, 0.32530,
                            result.solution.standard_errors->moments.y2, "E[y^2]", 4e-6);
  expect_power_balance(result);
  // The second simulation uses the mirrored problem.
  const SimulationResult mirrored = simulate_problem(
      problem_with_walls("0.1*v + y", "right = 0\nright_restitution = 1 - 0.3*min(1,abs(v))^0.2"),
      1e6);
  expect_within_four_errors(mirrored.solution.moments.y2, 0.32530,
                            mirrored.solution.standard_errors->moments.y2, "E[y^2]", 4e-6);
  expect_power_balance(mirrored);
}

TEST(RestitutionFormula, OfAConstantGivesTheBitsOfTheConstant) {
  const std::string walls = "right = 1.5\nright_restitution = 0.9\nleft = ";
  for (const std::string force : {"0.1*v + y", "0.1*v + sinh(y)"}) {
    for (const std::string left : {"-0.5", "0.3"}) {  // the mass rests on the wall at 0.3
      for (const std::string noise : {"", "[noise]\nintensity = 0.1\n"}) {
        SCOPED_TRACE(force + ", " + left + ' ' + noise);
        const auto problem = [&](const char* restitution) {
          return problem_of_case_text("[system]\nforce = " + force + "\n[wall]\n" + walls + left +
                                      "\nleft_restitution = " + restitution + '\n' + kImpulses +
                                      noise);
        };
        const SimulationResult constant = simulate_problem(problem("0.8"), 3e3),
                               same = simulate_problem(problem("0.8 + 0*v"), 3e3);
        EXPECT_EQ(same.solution.moments.y2, constant.solution.moments.y2);
        EXPECT_EQ(same.solution.moments.v4, constant.solution.moments.v4);
        EXPECT_EQ(same.summary.impact_rate.mean, constant.summary.impact_rate.mean);
        EXPECT_NEAR(same.solution.energy_residual, constant.solution.energy_residual, 1e-9);
        EXPECT_NEAR(*same.summary.balances.momentum, *constant.summary.balances.momentum, 1e-9);
        EXPECT_NEAR(*same.summary.balances.virial, *constant.summary.balances.virial, 1e-9);
        ASSERT_EQ(same.solution.atoms.size(), constant.solution.atoms.size());
        for (std::size_t n = 0; n < same.solution.atoms.size(); ++n) {
          EXPECT_EQ(same.solution.atoms[n].probability, constant.solution.atoms[n].probability);
        }
      }
    }
  }
}

// For a ball on a floor the total bounce time is known for each restitution law.
TEST(RestitutionFormula, BouncesEndInTheirExactTime) {
  const auto time_of = [](const char* formula, double speed) {
    const Problem problem =
        problem_with_walls("0.1*v + 2 + y", "left = 0\nleft_restitution = " + std::string(formula));
    const SimulatedOscillator ball = make_oscillator(problem, problem::motion_scales(problem));
    EXPECT_EQ(ball.left.contact_force, 2);
    return total_bounce_time(ball.left, speed);
  };
  double sum = 0;
  for (double u = 1e-3; u > 1e-30;) {
    u *= 1 - 0.3 * std::pow(u, 0.2);
    sum += u;
    if (u < 1e-12) break;
  }
  EXPECT_NEAR(time_of("1 - 0.3*min(1,v)^0.2", 1e-3), sum, 2e-3 * sum);
  EXPECT_NEAR(time_of("0.7 + 0*v", 1e-3), 1e-3 * 0.7 / 0.3, 1e-12);
  EXPECT_NEAR(time_of("0.7 - 0.1*min(1,v)", 1e-3), 1e-3 * 0.7 / 0.3, 1e-5);
  EXPECT_TRUE(std::isinf(time_of("1 - 0.3*min(1,v)", 1e-3)));
}

TEST(RestitutionFormula, WithEndlessBouncesIsRefused) {
  const auto reason = [](const std::string& force) {
    return unsupported_reason(
        problem_with_walls(force, "left = 0\nleft_restitution = 1 - 0.3*min(1,v)"), {});
  };
  EXPECT_NE(reason("0.1*v + y + 0.5").find("without end"), std::string::npos);
  EXPECT_EQ(reason("0.1*v + y - 0.5"), "");
}

TEST(RestitutionFormula, RestsInContactWithTheExactBalances) {
  for (const char* restitution : {"0.5 + 0.3*exp(-v)", "1 - 0.3*min(1,v)^0.2"}) {
    const SimulationResult result =
        simulate_problem(problem_with_walls("0.1*v + y + 0.5", "left = 0\nleft_restitution = " +
                                                                   std::string(restitution)),
                         1e5);
    expect_power_balance(result);
    ASSERT_EQ(result.solution.atoms.size(), 1u);
    EXPECT_GT(result.solution.atoms[0].probability, 1e-3);
  }
}

TEST(RestitutionFormula, IsPartOfTheFingerprint) {
  const auto print = [](const char* formula) {
    const Problem problem =
        problem_with_walls("0.1*v + y", "left = 0.2\nleft_restitution = " + std::string(formula));
    const Problem same =
        problem_with_walls("0.1*v + y", "left = 0.2\nleft_restitution = 0.8 - 0.1*min(1,v)");
    SimulationPlan plan =
        make_simulation_plan(tests::in_wall_coordinates(same), {.time = 1e4, .accuracy = 1});
    plan.oscillator = make_oscillator(problem, problem::motion_scales(problem));
    return simulation_fingerprint(problem, plan, nullptr);
  };
  EXPECT_NE(print("0.8 - 0.1*min(1,v)"), print("0.8 - 0.2*min(1,v)"));
}

}  // namespace
}  // namespace fpkcheck::mcs::formulas
