#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/input_error.hpp"
#include "exact/linear_density.hpp"
#include "general_oscillators.hpp"
#include "mcs/applicability.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::mcs {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using tests::gaussian_impulses;
using tests::with_impulses;

const problem::SystemCoefficients kLinear{.damping = 0.1, .stiffness = 1};

// The problems of cases/gap.ini, two_walls.ini and preload.ini, in wall coordinates.
Problem problem_with_gap() {
  return tests::in_wall_coordinates(
      with_impulses(System(kLinear, WallParameters{.left = -0.5, .left_restitution = 0.9}),
                    gaussian_impulses(1, 0.1)));
}
Problem problem_with_two_walls() {
  return tests::in_wall_coordinates(with_impulses(
      System(kLinear,
             {.left = -0.5, .left_restitution = 0.7, .right = 1, .right_restitution = 0.9}),
      gaussian_impulses(2, 0.2)));
}
Problem problem_with_preload() {
  return with_impulses(
      System({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7}),
      gaussian_impulses(1, 0.5));
}

double standard_error(const transform::Marginal& m, std::size_t b) {
  return (m.upper[b] - m.lower[b]) / (2 * 1.96);
}

struct Seen {
  int bins = 0, in_tail = 0;
  double chi_square = 0;
};

// Compares bins in which both simulations have approximately normal errors. The tail is the density
// below 1e-2 of the peak.
Seen expect_equal_marginals(const transform::Marginal& plain, const transform::Marginal& split) {
  constexpr double kWell = 0.15, kTail = 1e-2, kStandardErrors = 4;
  const double peak = *std::ranges::max_element(plain.density);
  Seen seen;
  for (std::size_t b = 0; b < plain.size(); ++b) {
    const double a = standard_error(plain, b), c = standard_error(split, b);
    if (!(a > 0 && a < kWell * plain.density[b] && c > 0 && c < kWell * split.density[b])) continue;
    const double off = (split.density[b] - plain.density[b]) / std::hypot(a, c);
    EXPECT_LT(std::abs(off), kStandardErrors) << plain.bin_centre(b);
    ++seen.bins;
    seen.in_tail += plain.density[b] < kTail * peak;
    seen.chi_square += off * off;
  }
  return seen;
}

TEST(TailsOfAnyOscillator, AreThoseOfAPlainSimulationWhereBothSeeThem) {
  for (const Problem& problem : {problem_with_gap(), problem_with_two_walls()}) {
    SCOPED_TRACE(problem.system.right_wall() ? "two walls" : "gap");
    const auto plain = simulate_stationary_density(problem, {.time = 2e6, .seed = 1}).solution;
    const SimulationResult split =
        simulate_stationary_density(problem, {.time = 1e5, .seed = 2, .tails = true});
    ASSERT_TRUE(split.solution.has_status_ok()) << split.solution.reason;
    EXPECT_GT(split.summary.thresholds.size(), 10u);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [variable, many] = plain.estimated_marginals[k];
      const auto& [same, few] = split.solution.estimated_marginals[k];
      const Seen seen = expect_equal_marginals(many, few);
      SCOPED_TRACE(transform::name(variable));
      EXPECT_GT(seen.bins, 60);
      // Between two walls y has no tail.
      const bool has_tail =
          variable == transform::StateVariable::ydot || !problem.system.right_wall();
      EXPECT_GT(seen.in_tail, has_tail ? 10 : -1);
      // The bins are correlated: a ratio of 1.6, above 1 + sqrt(2 / bins), is still consistent.
      EXPECT_LT(seen.chi_square / seen.bins, 1.6);
      // Splitting resolves bins that the plain simulation does not.
      int farther = 0;
      for (std::size_t b = 0; b < few.size(); ++b) {
        farther += standard_error(few, b) < 0.2 * few.density[b] &&
                   !(standard_error(many, b) < 0.4 * many.density[b]);
      }
      EXPECT_GT(farther, has_tail ? 10 : -1);
    }
    const auto &m = plain.moments, &n = split.solution.moments;
    const auto &e = plain.standard_errors->moments, &f = split.solution.standard_errors->moments;
    tests::expect_within_four_errors(n.y1, m.y1, std::hypot(e.y1, f.y1), "E[y]");
    tests::expect_within_four_errors(n.y2, m.y2, std::hypot(e.y2, f.y2), "E[y^2]");
    tests::expect_within_four_errors(n.v2, m.v2, std::hypot(e.v2, f.v2), "E[v^2]");
    tests::expect_within_four_errors(n.v4, m.v4, std::hypot(e.v4, f.v4), "E[v^4]");
    const auto& power = split.solution;
    EXPECT_LT(std::abs(power.energy_residual), 4 * power.standard_errors->energy_residual);
  }
}

// One impulse changes the energy from the centre of the density to its far tail, across a dozen
// thresholds. Without the limits of ImportanceSplitting 4^12 branches of one state took gigabytes
// and did not end.
TEST(TailsOfAnyOscillator, OfALawWithLongTailsAreBoundedAndThoseOfAPlainSimulation) {
  const System system({.damping = 0.2, .stiffness = 1, .cubic = 0.3},
                      WallParameters{.left = -0.3, .left_restitution = 0.7});
  const Problem problem =
      tests::in_wall_coordinates(with_impulses(system, problem::ImpulseTrain({.arrival_rate = 1,
                                                                              .law = "exponential",
                                                                              .intensity = 0.1,
                                                                              .mean = 0.1,
                                                                              .skewness = -2})));
  const auto plain = simulate_stationary_density(problem, {.time = 4e6, .seed = 1}).solution;
  const SimulationResult split =
      simulate_stationary_density(problem, {.time = 4e5, .seed = 2, .tails = true});
  ASSERT_TRUE(split.solution.has_status_ok()) << split.solution.reason;
  EXPECT_GT(split.summary.thresholds.size(), 5u);
  // About one branch per threshold, with a few flights between impulses.
  EXPECT_LT(split.summary.flights, 150 * split.summary.impulses);
  for (std::size_t k = 0; k < 2; ++k) {
    const Seen seen = expect_equal_marginals(plain.estimated_marginals[k].second,
                                             split.solution.estimated_marginals[k].second);
    EXPECT_GT(seen.in_tail, 10);
    EXPECT_LT(seen.chi_square / seen.bins, 1.6);
  }
  const auto &m = plain.moments, &n = split.solution.moments;
  const auto &e = plain.standard_errors->moments, &f = split.solution.standard_errors->moments;
  tests::expect_within_four_errors(n.y2, m.y2, std::hypot(e.y2, f.y2), "E[y^2]");
  tests::expect_within_four_errors(n.v4, m.v4, std::hypot(e.v4, f.v4), "E[v^4]");
}

// Branches at rest contribute with their weights.
TEST(TailsOfAnyOscillator, PreserveTheProbabilityOfRest) {
  const auto plain =
      simulate_stationary_density(problem_with_preload(), {.time = 4e5, .seed = 1}).solution;
  const auto split =
      simulate_stationary_density(problem_with_preload(), {.time = 1e5, .seed = 2, .tails = true})
          .solution;
  ASSERT_EQ(plain.atoms.size(), 1u);
  ASSERT_EQ(split.atoms.size(), 1u);
  const auto &p = plain.atoms.front(), &q = split.atoms.front();
  tests::expect_within_four_errors(q.probability, p.probability,
                                   std::hypot(*p.standard_error, *q.standard_error), "P(rest)");
  EXPECT_NEAR(split.mass, 1, 1e-2);  // the weights of branches sum to 1 on average only
  for (std::size_t k = 0; k < 2; ++k) {
    expect_equal_marginals(plain.estimated_marginals[k].second,
                           split.estimated_marginals[k].second);
  }
}

// Without a wall y has the law of z of the paper's linear oscillator with r = 1.
TEST(TailsOfAnyOscillator, AreExactDownTo1eMinus8OfThePeakWithoutAWall) {
  const auto folded = tests::make_problem({.cubic = 0, .restitution = 1});
  const exact::LinearDensity density(folded);
  Problem problem = folded;
  problem.system = System(
      {.damping = folded.system.damping(), .stiffness = folded.system.stiffness()}, {.none = true});
  const SimulationResult result =
      simulate_stationary_density(problem, {.time = 1.6e5, .seed = 5, .tails = true});
  EXPECT_GT(result.summary.thresholds.size(), 10u);
  const auto& [variable, estimate] = result.solution.estimated_marginals.back();
  ASSERT_EQ(variable, transform::StateVariable::ydot);
  // Average of both halves of the (z, z') plane, which are mirror images.
  const auto half = density.velocity_averages(estimate.edges);
  std::vector<double> truth = half;
  for (std::size_t b = 0; b < half.size(); ++b)
    truth[b] = (half[b] + half[half.size() - 1 - b]) / 2;
  const double peak = *std::ranges::max_element(truth);
  int far = 0;
  for (std::size_t b = 0; b < truth.size(); ++b) {
    if (truth[b] < 1e-8 * peak) continue;
    EXPECT_NEAR(estimate.density[b], truth[b], 5 * standard_error(estimate, b)) << b;
    EXPECT_LT(standard_error(estimate, b), 0.25 * truth[b]) << b;
    far += truth[b] < 1e-6 * peak;
  }
  EXPECT_GT(far, 5);
}

TEST(TailsOfAnyOscillator, DoNotDependOnThreadsAndGoOnFromACheckpoint) {
  const tests::TemporaryDirectory directory;
  const std::string file = (directory.path() / "state").string();
  const SimulationOptions options{.time = 3e3, .threads = 1, .streams = 20, .tails = true};
  SimulationOptions parallel = options, first = options, rest = options;
  parallel.threads = 3;
  const auto moments = [](const SimulationOptions& o) {
    return simulate_stationary_density(problem_with_preload(), o).solution.moments;
  };
  const auto one = moments(options);
  EXPECT_EQ(moments(parallel).v4, one.v4);
  int rounds = 0;
  first.checkpoint = file;
  first.stop = [&] { return ++rounds == 3; };
  moments(first);
  rest.resume = file;
  const auto resumed = moments(rest);
  EXPECT_EQ(resumed.y2, one.y2);
  EXPECT_EQ(resumed.v4, one.v4);
}

TEST(TailsOfAnyOscillator, AreNotSupportedWhereTheEnergyRisesBetweenImpulses) {
  const SimulationOptions tails{.tails = true};
  for (const Problem& problem :
       {problem_with_gap(), problem_with_two_walls(), problem_with_preload()}) {
    EXPECT_EQ(unsupported_reason(problem, tails), "");
    EXPECT_NE(unsupported_reason(problem, {.equation = DensityEquation::white, .tails = true}), "");
  }
  Problem noisy = problem_with_gap();
  noisy.noise.intensity = 0.1;
  EXPECT_NE(unsupported_reason(noisy, tails).find("noise"), std::string::npos);
  EXPECT_THROW(simulate_stationary_density(noisy, {.time = 1e3, .tails = true}), InputError);
  const Problem ring =
      with_impulses(System({.damping = -0.1, .van_der_pol = 0.1, .stiffness = 1}, {.none = true}),
                    gaussian_impulses(1, 0.1));
  EXPECT_NE(unsupported_reason(ring, tails).find("damping"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::mcs
