#include "compare/distances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/comparison_bins.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Marginal;

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// N(mean, deviation^2) as exact bin averages. Bins of width h change distances by O(h^2).
Marginal normal(double mean, double deviation, int bins = 4000) {
  Marginal m;
  for (int k = 0; k <= bins; ++k) m.edges.push_back(-10 + 20.0 * k / bins);
  for (int k = 0; k < bins; ++k) {
    const double a = (m.edges[k] - mean) / deviation, b = (m.edges[k + 1] - mean) / deviation;
    // Differences of the smaller tail: the difference of two numbers near 1 would lose digits.
    const double p = a > 0 ? normal_cdf(-a) - normal_cdf(-b) : normal_cdf(b) - normal_cdf(a);
    m.density.push_back(p / (m.edges[k + 1] - m.edges[k]));
  }
  return m;
}

constexpr double kBinning = 5e-5;  // (20/4000)^2, with a factor 2

TEST(Distances, OfShiftedNormalsAreTheClosedForms) {
  const double shift = 0.3;
  const auto d = compute_distances(normal(shift, 1), normal(0, 1));
  // The curves cross at shift/2: int |a-b| = 2 (2 Phi(shift/2) - 1).
  EXPECT_NEAR(d.l1, 2 * (2 * normal_cdf(shift / 2) - 1), kBinning);
  // int (a-b)^2 = (1 - exp(-shift^2/4)) / sqrt(pi).
  EXPECT_NEAR(d.l2, std::sqrt((1 - std::exp(-shift * shift / 4)) / std::sqrt(M_PI)), kBinning);
  EXPECT_NEAR(d.hellinger, std::sqrt(1 - std::exp(-shift * shift / 8)), kBinning);
  EXPECT_NEAR(d.kl, shift * shift / 2, kBinning);
  double sup = 0;
  for (double x = -4; x < 4; x += 1e-4) {
    sup = std::max(sup, std::abs(std::exp(-x * x / 2) - std::exp(-(x - shift) * (x - shift) / 2)));
  }
  EXPECT_NEAR(d.sup, sup / std::sqrt(2 * M_PI), kBinning);
}

TEST(Distances, TheDivergenceIsThatOfTheReferenceFromItsSubstitute) {
  // KL(N(0, s_b^2) || N(0, s_a^2)) = log(s_a/s_b) + s_b^2 / (2 s_a^2) - 1/2.
  const auto exact = [](double sb, double sa) {
    return std::log(sa / sb) + sb * sb / (2 * sa * sa) - 0.5;
  };
  const auto wide = normal(0, 1.2), narrow = normal(0, 0.9);
  ASSERT_GT(std::abs(exact(0.9, 1.2) - exact(1.2, 0.9)), 100 * kBinning);
  EXPECT_NEAR(compute_distances(wide, narrow).kl, exact(0.9, 1.2), kBinning);
  EXPECT_NEAR(compute_distances(narrow, wide).kl, exact(1.2, 0.9), kBinning);
}

TEST(Distances, OfADensityFromItselfAreZero) {
  const auto d = compute_distances(normal(0.1, 1), normal(0.1, 1));
  for (const double value : {d.l1, d.l2, d.sup, d.hellinger, d.kl}) EXPECT_EQ(value, 0.0);
  for (const auto& tail : d.log10_tail) EXPECT_EQ(tail.mean_abs, 0.0);
}

TEST(Distances, OfDisjointDensitiesAreTheLargestPossible) {
  const Marginal left{{0, 1, 2}, {1, 0}, {}, {}}, right{{0, 1, 2}, {0, 1}, {}, {}};
  const auto d = compute_distances(left, right);
  EXPECT_EQ(d.l1, 2.0);
  EXPECT_EQ(d.hellinger, 1.0);
  EXPECT_EQ(d.kl, std::numeric_limits<double>::infinity());
}

TEST(Distances, TheDivergenceIsFiniteWhereOnlyTheReferenceIsZero) {
  const Marginal spread{{0, 1, 2}, {0.5, 0.5}, {}, {}}, narrow{{0, 1, 2}, {1, 0}, {}, {}};
  EXPECT_NEAR(compute_distances(spread, narrow).kl, std::log(2.0), 1e-15);
  EXPECT_EQ(compute_distances(narrow, spread).kl, std::numeric_limits<double>::infinity());
}

TEST(Distances, UnequalBinsAreWeightedByTheirWidths) {
  const Marginal a{{0, 1, 4}, {0.4, 0.2}, {}, {}}, b{{0, 1, 4}, {0.1, 0.3}, {}, {}};
  const auto d = compute_distances(a, b);
  EXPECT_NEAR(d.l1, 0.3 + 3 * 0.1, 1e-15);
  EXPECT_NEAR(d.l2, std::sqrt(0.09 + 3 * 0.01), 1e-15);
}

TEST(Distances, ANegativeAverageCountsInL1AndIsZeroForTheDivergence) {
  const Marginal a{{0, 1, 2}, {1.1, -0.1}, {}, {}}, b{{0, 1, 2}, {1, 0}, {}, {}};
  const auto d = compute_distances(a, b);
  EXPECT_NEAR(d.l1, 0.2, 1e-15);
  EXPECT_NEAR(d.kl, std::log(1 / 1.1) - 1 + 1.1, 1e-15);
  EXPECT_NEAR(compute_distances(b, a).kl, 1.1 * std::log(1.1) - 1.1 + 1, 1e-15);
}

TEST(Distances, OfNonFiniteDensitiesAreNaN) {
  const Marginal broken{{0, 1, 2}, {1, std::nan("")}, {}, {}}, b{{0, 1, 2}, {1, 0}, {}, {}};
  for (const auto& d : {compute_distances(broken, b), compute_distances(b, broken)}) {
    for (const double value : {d.l1, d.l2, d.sup, d.hellinger, d.kl}) {
      EXPECT_TRUE(std::isnan(value));
    }
    EXPECT_TRUE(d.log10_tail.empty());
  }
}

TEST(Distances, ThrowForDifferentBinsOrSizes) {
  const Marginal a{{0, 1, 2}, {1, 0}, {}, {}};
  EXPECT_THROW(compute_distances(a, {{0, 1, 3}, {1, 0}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(compute_distances(a, {{0, 1, 2}, {1}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(compute_distances(a, {{0, 1, 2}, {1, 0}, {1}, {1}}), std::invalid_argument);
}

TEST(TailDistance, IsTheMeanLogarithmByDecadesOfTheReference) {
  // Bins of b in two decades; a / b is 10, 100 and 1/10.
  const Marginal b{{0, 1, 2, 3, 4}, {0.5, 2e-3, 5e-3, 3e-8}, {}, {}};
  const Marginal a{{0, 1, 2, 3, 4}, {5, 2e-1, 5e-4, 1}, {}, {}};
  const auto tail = compute_distances(a, b).log10_tail;
  ASSERT_EQ(tail.size(), 6u);
  EXPECT_NEAR(tail[0].mean_abs, 1, 1e-14);
  EXPECT_EQ(tail[0].bins, 1);
  EXPECT_TRUE(std::isnan(tail[1].mean_abs));
  EXPECT_EQ(tail[1].bins, 0);
  EXPECT_NEAR(tail[2].from, 1e-3, 1e-18);
  EXPECT_NEAR(tail[2].to, 1e-2, 1e-17);
  EXPECT_NEAR(tail[2].mean_abs, 1.5, 1e-14);
  EXPECT_EQ(tail[2].bins, 2);
  EXPECT_NEAR(tail[5].from, 1e-6, 1e-21);
}

TEST(TailDistance, OmitsAndCountsNoisyAndNonpositiveBins) {
  const std::vector<double> edges{0, 1, 2, 3};
  // Half-widths of 40 %, 60 % and 40 % of the reference.
  const Marginal b{edges, {0.5, 0.5, 0.5}, {0.3, 0.2, 0.3}, {0.7, 0.8, 0.7}};
  const auto tail = compute_distances({edges, {0.05, 5, -1}, {}, {}}, b).log10_tail.front();
  EXPECT_NEAR(tail.mean_abs, 1, 1e-14);
  EXPECT_EQ(tail.bins, 1);
  EXPECT_EQ(tail.omitted_bin_count, 2);
}

TEST(ComparisonAxes, CoverSevenDeviationsWithAnEdgeAtZeroVelocity) {
  const auto problem = tests::paper_case(4);
  const auto bell = problem::equivalent_linearisation(problem);
  const auto axes = comparison_bins(problem);
  EXPECT_EQ(axes.y_edges.front(), 0.0);
  EXPECT_NEAR(axes.y_edges.back(), 7 * bell.displacement_deviation, 1e-14);
  EXPECT_NEAR(axes.v_edges.back(), 7 * bell.velocity_deviation, 1e-14);
  EXPECT_EQ(axes.v_edges[axes.v_edges.size() / 2], 0.0);
  for (std::size_t k = 0; k < axes.v_edges.size(); ++k) {
    EXPECT_EQ(axes.v_edges[k], -axes.v_edges[axes.v_edges.size() - 1 - k]);
  }
  EXPECT_EQ(&comparison_bin_edges(axes, transform::StateVariable::y), &axes.y_edges);
  EXPECT_EQ(&comparison_bin_edges(axes, transform::StateVariable::ydot), &axes.v_edges);
}

}  // namespace
}  // namespace fpkcheck::compare
