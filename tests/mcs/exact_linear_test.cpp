#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "mcs/solve.hpp"
#include "mcs/streams/trajectory_stream.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"
#include "uniform_edges.hpp"

// Compares all estimates with the exact stationary density of the linear oscillator with r = 1
// under impulses.
namespace fpkcheck::mcs {
namespace {

problem::Problem linear() { return tests::make_problem({.cubic = 0, .restitution = 1}); }

// Returns the sum over bins of the average density times the exact integral of x^order over the
// bin.
double moment_of_histogram(const std::vector<double>& edges, const std::vector<double>& averages,
                           int order) {
  double sum = 0;
  for (std::size_t b = 0; b < averages.size(); ++b) {
    sum += averages[b] * (std::pow(edges[b + 1], order + 1) - std::pow(edges[b], order + 1)) /
           (order + 1);
  }
  return sum;
}

/// E[y^p y'^q] in the order of kRecordedMomentPowers. Moments of even total order are those of (z,
/// z'), from the cumulants. Moments of odd order follow from the marginals and from d/dt E[y^n] = 0
/// and d/dt E[y y'] = 0, which give E[y^2 v] = 0 and E[v^3] = 2c (E[y v^2] - E[y] E[v^2]).
std::vector<double> exact_moments() {
  const auto problem = linear();
  const exact::LinearDensity density(problem);
  const auto y = tests::uniform_edges(0, 6, 1500), v = tests::uniform_edges(-6, 6, 1500);
  const auto p_y = density.displacement_averages(y), p_v = density.velocity_averages(v);
  const auto kappa = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
  const double zz = kappa(2, 0), vv = kappa(0, 2), zv = kappa(1, 1);
  const double y1 = moment_of_histogram(y, p_y, 1), v3 = moment_of_histogram(v, p_v, 3);
  const double yvv = v3 / (2 * problem.system.damping()) + y1 * vv;
  return {y1,
          0,
          zz,
          zv,
          vv,
          moment_of_histogram(y, p_y, 3),
          0,
          yvv,
          v3,
          kappa(4, 0) + 3 * zz * zz,
          kappa(3, 1) + 3 * zz * zv,
          kappa(2, 2) + zz * vv + 2 * zv * zv,
          kappa(1, 3) + 3 * vv * zv,
          kappa(0, 4) + 3 * vv * vv};
}

TEST(ExactLinear, AllMomentsToOrderFourAreWithinFourStandardErrorsForTwentySeeds) {
  const auto truth = exact_moments();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto summary = tests::simulate(linear(), 1e5, seed).summary;
    for (std::size_t n = 0; n < kRecordedMomentPowers.size(); ++n) {
      const auto [mean, error] = summary.joint_moments[n];
      EXPECT_NEAR(mean, truth[n], 4 * error)
          << "y^" << kRecordedMomentPowers[n].first << " v^" << kRecordedMomentPowers[n].second
          << ", seed " << seed << ": " << (mean - truth[n]) / error;
    }
  }
}

struct Coverage {
  double covered = 0, all = 0;
  void add(bool inside) {
    covered += inside;
    ++all;
  }
  double share() const { return covered / all; }
};

// The errors of bins, moments and quantiles of one run are correlated, so the test averages over
// runs.
TEST(ExactLinear, IntervalsOf95PerCentCoverTheTruthBetween90And99PerCent) {
  const auto problem = linear();
  const auto truth = exact_moments();
  const exact::LinearDensity density(problem);
  SimulationOptions options{.time = 1e4,
                            .streams = 24,
                            .y_edges = tests::uniform_edges(0, 3, 30),
                            .v_edges = tests::uniform_edges(-3, 3, 40)};
  const auto p_y = density.displacement_averages(options.y_edges);
  const auto p_v = density.velocity_averages(options.v_edges);
  const auto p = density.joint_averages(options.y_edges, options.v_edges);
  Coverage of_moments, of_y, of_v, of_cells, of_quantiles;
  for (int run = 0; run < 100; ++run) {
    options.seed = 1000 + run;
    const SimulationResult result = simulate_stationary_density(problem, options);
    constexpr double kStudent = 2.0796;  // 21 degrees of freedom
    for (std::size_t n = 0; n < kRecordedMomentPowers.size(); ++n) {
      const auto [mean, error] = result.summary.joint_moments[n];
      of_moments.add(std::abs(mean - truth[n]) < kStudent * error);
    }
    for (const auto& [variable, estimate] : result.solution.estimated_marginals) {
      const bool is_y = variable == transform::StateVariable::y;
      const auto& averages = is_y ? p_y : p_v;
      for (std::size_t b = 0; b < averages.size(); ++b) {
        if (averages[b] < 0.02) continue;  // only bins with samples in every stream
        (is_y ? of_y : of_v)
            .add(averages[b] > estimate.lower[b] && averages[b] < estimate.upper[b]);
      }
    }
    const auto& joint = std::get<transform::GridDensity>(*result.solution.density);
    for (std::size_t cell = 0; cell < p.size(); ++cell) {
      if (p[cell] < 0.05) continue;
      of_cells.add(std::abs(joint.averages[cell] - p[cell]) <
                   kStudent * result.summary.joint_standard_errors[cell]);
    }
    double below = 0;
    std::size_t bin = 0;
    for (const QuantileWithConfidenceInterval& q : result.summary.y_quantiles) {
      if (q.probability < 0.05 || q.probability > 0.99) continue;
      // The exact quantile, with a distribution function linear within a bin.
      while (below + p_y[bin] * 0.1 < q.probability) below += p_y[bin++] * 0.1;
      const double share = (q.probability - below) / (p_y[bin] * 0.1);
      const double exact_value = options.y_edges[bin] + 0.1 * share;
      EXPECT_NEAR(q.value, exact_value, 0.1);
      of_quantiles.add(exact_value > q.lower - 1e-3 && exact_value < q.upper + 1e-3);
    }
  }
  for (const auto& coverage : {of_moments, of_y, of_v, of_cells, of_quantiles}) {
    EXPECT_GT(coverage.all, 500);
    EXPECT_GT(coverage.share(), 0.90);
    EXPECT_LT(coverage.share(), 0.99);
  }
}

// With the same impulses the trajectories of both steps converge to each other in these cases. In
// case 4 neighbouring trajectories diverge, and the comparison is impossible.
TEST(ExactLinear, HalvingTheStepMovesMomentsByLessThanATenthOfTheirError) {
  for (const auto& problem : {linear(), tests::paper_case(1), tests::paper_case(2)}) {
    SimulationOptions options{.time = 1e5, .seed = 3};
    const SimulationResult coarse = simulate_stationary_density(problem, options);
    options.step = coarse.summary.step / 2;
    const SimulationResult fine = simulate_stationary_density(problem, options);
    EXPECT_GT(fine.summary.flights, coarse.summary.flights);
    for (std::size_t n = 0; n < kRecordedMomentPowers.size(); ++n) {
      const auto &a = coarse.summary.joint_moments[n], &b = fine.summary.joint_moments[n];
      EXPECT_NEAR(a.mean, b.mean, 0.01 * b.standard_error) << n;
    }
  }
}

// Rice's formula: int v p(a, v) dv over v > 0.
TEST(ExactLinear, LevelsAreCrossedUpwardsAtRicesRate) {
  const auto problem = linear();
  const exact::LinearDensity density(problem);
  const auto summary = tests::simulate(problem, 3e5).summary;
  const auto v = tests::uniform_edges(0, 6, 600);
  int compared = 0;
  for (const RateOfEventsAtLevel& crossing : summary.crossings) {
    if (crossing.rate.mean < 1e-4) continue;
    const double a = crossing.level, narrow = 1e-3;
    const std::vector<double> strip{a - narrow, a + narrow};
    const auto p = density.joint_averages(strip, v);
    const double rice = moment_of_histogram(v, p, 1);
    tests::expect_within_four_errors(crossing.rate.mean, rice, crossing.rate.standard_error, "rate",
                                     1e-6);
    ++compared;
  }
  EXPECT_GT(compared, 4);
  const auto wall = density.joint_averages(std::vector<double>{0, 1e-3}, v);
  // Impacts with r = 1 preserve the speed.
  tests::expect_within_four_errors(summary.impact_rate.mean, moment_of_histogram(v, wall, 1),
                                   summary.impact_rate.standard_error, "impacts", 2e-6);
  // After each crossing of the first level follows a peak above this level.
  EXPECT_GE(summary.peaks[1].rate.mean, summary.crossings[0].rate.mean);
  EXPECT_GE(summary.peaks[0].rate.mean, summary.peaks[1].rate.mean);
}

TEST(ExactLinear, SplittingResolvesTheTailsDownTo1eMinus8OfThePeak) {
  const auto problem = linear();
  const exact::LinearDensity density(problem);
  SimulationOptions options{.time = 6e4, .seed = 5, .tails = true};
  const SimulationResult result = simulate_stationary_density(problem, options);
  EXPECT_GT(result.summary.thresholds.size(), 10u);
  for (const auto& [variable, estimate] : result.solution.estimated_marginals) {
    const auto truth = variable == transform::StateVariable::y
                           ? density.displacement_averages(estimate.edges)
                           : density.velocity_averages(estimate.edges);
    const double peak = *std::ranges::max_element(truth);
    Coverage covered;
    int far = 0;
    for (std::size_t b = 0; b < truth.size(); ++b) {
      if (truth[b] < 1e-8 * peak) continue;
      covered.add(truth[b] > estimate.lower[b] && truth[b] < estimate.upper[b]);
      const double half = (estimate.upper[b] - estimate.lower[b]) / 2;
      EXPECT_NEAR(estimate.density[b], truth[b], 2.5 * half) << b;
      EXPECT_LT(half, 0.5 * truth[b]) << b;
      far += truth[b] < 1e-6 * peak;
    }
    EXPECT_GT(far, 5);
    EXPECT_GT(covered.share(), 0.85);
  }
  const auto truth = exact_moments();
  for (std::size_t n = 0; n < kRecordedMomentPowers.size(); ++n) {
    const auto [mean, error] = result.summary.joint_moments[n];
    EXPECT_NEAR(mean, truth[n], 4 * error) << n;
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
