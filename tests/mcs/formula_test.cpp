#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "general_oscillators.hpp"
#include "mcs/applicability.hpp"
#include "mcs/motion/advance.hpp"
#include "mcs/motion/taylor_flight.hpp"
#include "mcs/solve.hpp"
#include "problem/motion_scales.hpp"
#include "simulate_and_compare.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::mcs::formulas {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using tests::expect_near;
using tests::gaussian_impulses;
using tests::with_impulses;
using tests::with_noise;

const WallParameters kNoWall{.none = true};

System formula(const std::string& force, const WallParameters& walls = kNoWall) {
  return System({.force = force}, walls);
}

Result simulated(const Problem& problem, double time, double step = 0.9) {
  return solve(tests::in_wall_coordinates(problem),
               {.time = time, .accuracy = 1, .seed = 20261126, .step = step});
}

/// Streams without impulses.
struct FreeStreams {
  const System& system;
  BinFinder y{tests::uniform_edges(-4, 4, 50)}, v{tests::uniform_edges(-5, 5, 50)};
  MotionParameters motion;
  std::deque<Stream> streams{};

  FreeStreams(const Problem& problem, const std::vector<State>& starts, double step = 0.9,
              const NoiseKicks& kicks = {})
      : system(problem.system),
        motion{.oscillator = make_oscillator(problem, problem::scales(problem)),
               .kicks = kicks,
               .step = step,
               .sampling_interval = 0.25,
               .y_bins = &y,
               .v_bins = &v} {
    for (const State& start : starts) {
      const auto number = static_cast<std::uint32_t>(streams.size());
      streams.push_back({.branch = {.y = start.y,
                                    .v = start.v,
                                    .until_impulse = std::numeric_limits<double>::infinity(),
                                    .amplitude = 0,
                                    .until_sample = 0.125,
                                    .remaining = 0},
                         .source = ImpulseSource(problem.impulses, 1, number),
                         .record = StreamStatistics(y, v),
                         .noise = NoiseSource(1, number)});
      if (kicks.is_present()) {
        streams.back().branch.kick_interval = kicks.longest_interval;
        streams.back().branch.until_kick = kicks.longest_interval / 2;
      }
    }
  }
  FreeStreams(const FreeStreams&) = delete;

  void advance(double time,
               const simd::SimdVariant& lanes = simd::available_simd_variants().back()) {
    std::vector<Stream*> pointers;
    for (Stream& stream : streams) pointers.push_back(&stream);
    mcs::advance(motion, pointers, time, lanes);
  }
};

const Problem kPolynomial = with_impulses(
    System({.damping = 0.1, .stiffness = 1, .cubic = 0.1}, kNoWall), gaussian_impulses(1, 0.5));
const Problem kSameFormula =
    with_impulses(formula("0.1*v + y + 0.1*y^3 + 0*abs(y)"), gaussian_impulses(1, 0.5));
const std::vector<State> kStarts{{0.3, 0.9}, {-1.5, 0}, {0, 2.5}, {3, -1}};

double distance(const Branch& a, const Branch& b) { return std::hypot(a.y - b.y, a.v - b.v); }

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
  const Problem smooth = with_impulses(formula("0.1*v + tanh(y) + y"), gaussian_impulses(1, 0.5));
  const auto end = [&](double step) {
    FreeStreams free(smooth, {{1.2, 1.9}}, step);
    free.advance(20);
    return free.streams[0].branch;
  };
  const Branch fine = end(0.1125);
  const double order = std::log2(distance(end(0.9), fine) / distance(end(0.45), fine));
  EXPECT_GT(order, 3.8);
  EXPECT_LT(order, 6.5);
}

TEST(Formula, HasTheMomentsOfItsPolynomial) {
  const WallParameters wall{.left = -0.5, .left_restitution = 0.8};
  const Problem gap = with_impulses(System({.damping = 0.1, .stiffness = 1, .cubic = 0.1}, wall),
                                    gaussian_impulses(1, 0.5));
  const Problem same =
      with_impulses(formula("0.1*v + y + 0.1*y^3 + 0*abs(y)", wall), gaussian_impulses(1, 0.5));
  for (const auto& [a, b] : {std::pair{kPolynomial, kSameFormula}, std::pair{gap, same}}) {
    const Result polynomial = simulated(a, 3e4), integrated = simulated(b, 3e4);
    const auto &m = polynomial.solution.moments, &n = integrated.solution.moments;
    const auto& e = polynomial.solution.standard_errors->moments;
    // The simulations have the same impulses.
    expect_near(n.y1, m.y1, e.y1, "E[y]");
    expect_near(n.y2, m.y2, e.y2, "E[y^2]");
    expect_near(n.v2, m.v2, e.v2, "E[v^2]");
    expect_near(n.v4, m.v4, e.v4, "E[v^4]");
    expect_near(integrated.summary.impact_rate.mean, polynomial.summary.impact_rate.mean,
                polynomial.summary.impact_rate.standard_error + 1e-12, "impacts");
  }
}

TEST(Formula, RestsInContactAsItsPolynomialDoes) {
  const WallParameters wall{.left = 0.5, .left_restitution = 0.5};
  const Problem a =
      with_impulses(System({.damping = 0.1, .stiffness = 1}, wall), gaussian_impulses(1, 0.2));
  const Problem b = with_impulses(formula("0.1*v + y + 0*abs(y)", wall), gaussian_impulses(1, 0.2));
  const Result polynomial = simulated(a, 3e4), integrated = simulated(b, 3e4);
  ASSERT_EQ(integrated.solution.atoms.size(), 1u);
  expect_near(integrated.solution.atoms[0].probability, polynomial.solution.atoms[0].probability,
              *polynomial.solution.atoms[0].standard_error, "atom");
  expect_near(*integrated.summary.balances.momentum, 0, *integrated.summary.balance_errors.momentum,
              "momentum");
  expect_near(*integrated.summary.balances.virial, 0, *integrated.summary.balance_errors.virial,
              "virial");
}

TEST(Formula, MomentsDoNotDependOnTheStep) {
  for (const char* force : {"0.1*v + y + 4*max(y-0.5,0)", "0.2*v*abs(v) + y + 0.1*y^3",
                            "0.1*v + 0.05*tanh(20*v) + y", "0.1*v + y - 50*max(-y,0)^1.5"}) {
    const Problem problem = with_impulses(formula(force), gaussian_impulses(1, 0.5));
    const auto coarse = simulated(problem, 1e4).solution.moments,
               fine = simulated(problem, 1e4, 0.45).solution.moments;
    EXPECT_NEAR(coarse.y2 / fine.y2, 1, 1e-5) << force;
    EXPECT_NEAR(coarse.v2 / fine.v2, 1, 1e-5) << force;
  }
}

void expect_balance(const Result& result) {
  const auto& [solution, summary] = result;
  expect_near(solution.energy_residual, 0, solution.standard_errors->energy_residual, "power");
  expect_near(*summary.balances.virial, 0, *summary.balance_errors.virial, "virial");
  expect_near(*summary.balances.momentum, 0, *summary.balance_errors.momentum, "momentum");
}

// Without walls E[v f] = I/2, hence E[v^2] = I/(2 c) for linear damping.
TEST(Formula, UnderImpulsesHasTheExactBalances) {
  const Problem spring =
      with_impulses(formula("0.1*v + y + 4*max(y-0.5,0)"), gaussian_impulses(1, 0.2));
  const Result result = simulated(spring, 1e5);
  expect_near(result.solution.moments.v2, 1, result.solution.standard_errors->moments.v2, "E[v^2]");
  expect_balance(result);
  expect_balance(simulated(
      with_impulses(formula("0.2*v*abs(v) + y + 0.1*y^3"), gaussian_impulses(1, 0.5)), 3e4));
  // A mirrored frame and a mean of the impulses.
  expect_balance(simulated(with_impulses(formula("0.1*v + 0.1*tanh(5*v) + y + 0.2*max(y,0)^1.5",
                                                 {.right = 0.3, .right_restitution = 0.8}),
                                         gaussian_impulses(1, 0.3, 0.1)),
                           3e4));
}

// E[v^2] = D/c for linear damping and any spring, also with an elastic wall.
TEST(Formula, UnderWhiteNoiseHasTheExactMeanKineticEnergy) {
  const WallParameters wall{.left = -0.5, .left_restitution = 1};
  for (const Problem& problem :
       {with_noise(formula("0.2*v + 2*tanh(y)"), 0.4), with_noise(formula("0.2*v + sinh(y)"), 0.4),
        with_noise(formula("0.2*v + sinh(y)", wall), 0.4)}) {
    const Result result = simulated(problem, 6e4);
    const auto& e = result.solution.standard_errors->moments;
    expect_near(result.solution.moments.v2, 1, e.v2, "E[v^2]");
    expect_near(result.solution.moments.v4, 3, e.v4, "E[v^4]");
    expect_balance(result);
  }
}

// Dry friction: the balance of power is mu_c E[|v|] = D.
TEST(Formula, UnderWhiteNoiseMayHaveJumps) {
  const Problem friction = with_noise(formula("0.2*sign(v) + y"), 0.2);
  EXPECT_EQ(unsupported_reason(friction, {}), "");
  expect_balance(simulated(friction, 3e4));
}

TEST(Formula, GivesTheSameBitsForAnyWidthAndInstructions) {
  const Problem problem = tests::in_wall_coordinates(with_impulses(
      formula("0.1*v + 0.05*tanh(20*v) + y + 0.1*exp(-y) + 0.1*sin(y) + max(y,0)^1.3",
              {.left = -0.3, .left_restitution = 0.8, .right = 1.2, .right_restitution = 0.7}),
      gaussian_impulses(1, 0.5)));
  std::vector<State> starts;
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
        const Stream &a = reference.streams[s], &b = group.streams[s];
        EXPECT_EQ(a.branch.y, b.branch.y);
        EXPECT_EQ(a.branch.v, b.branch.v);
        EXPECT_EQ(a.record.powers, b.record.powers);
        EXPECT_EQ(a.record.force_v, b.record.force_v);
        EXPECT_EQ(a.record.histogram.weights(), b.record.histogram.weights());
        EXPECT_EQ(a.record.flights, b.record.flights);
      }
    }
  }
}

TEST(Formula, ResumesFromACheckpointOfTheSameFormulaOnly) {
  const std::string file = testing::TempDir() + "fpkcheck_formula";
  const auto problem = [](const char* force) {
    return with_impulses(formula(force), gaussian_impulses(1, 0.5));
  };
  const Problem one = problem("0.1*v + sinh(y)"), other = problem("0.1*v + sinh(1.1*y)");
  const Options whole{.time = 1e4, .accuracy = 1, .streams = 20};
  Options first = whole, second = whole;
  int rounds = 0;
  first.checkpoint = second.resume = file;
  first.stop = [&] { return ++rounds == 3; };
  solve(one, first);
  EXPECT_EQ(solve(one, second).solution.moments.y4, solve(one, whole).solution.moments.y4);
  EXPECT_ANY_THROW(solve(other, second));
  std::remove(file.c_str());
}

TEST(Formula, IsRefusedWithAReasonWhereItIsNotSupported) {
  const Problem friction = with_impulses(formula("0.2*sign(v) + y"), gaussian_impulses(1, 0.5));
  EXPECT_NE(unsupported_reason(friction, {}).find("tanh(v/eps)"), std::string::npos);
  EXPECT_EQ(unsupported_reason(friction, {.equation = DensityEquation::white}), "");
  EXPECT_EQ(unsupported_reason(kSameFormula, {}), "");
  EXPECT_NE(unsupported_reason(kSameFormula, {.tails = true}).find("formula"), std::string::npos);
}

// The spring is that of a Duffing oscillator at a wall, which has its own simulation.
TEST(Formula, OfTheRestitutionIsRefused) {
  const Problem variable =
      with_impulses(System({.damping = 0.1, .stiffness = 1},
                           {.left = 0, .left_restitution = std::string("1 - 0.3*min(1, v)^0.2")}),
                    gaussian_impulses(1, 0.2));
  EXPECT_NE(unsupported_reason(variable, {}), "");
}

// Beyond the wall sqrt(y) does not exist, and the trial states of a step are beyond the wall.
TEST(Formula, NeedNotExistBeyondTheWall) {
  const Problem problem =
      with_impulses(formula("0.1*v + y + sqrt(y)", {.left = 0, .left_restitution = 0.8}),
                    gaussian_impulses(1, 0.5));
  const Result result = simulated(problem, 1e4);
  ASSERT_TRUE(result.solution.is_ok()) << result.solution.reason;
  expect_balance(result);
}

}  // namespace
}  // namespace fpkcheck::mcs::formulas
