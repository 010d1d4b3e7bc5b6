#include "transform/smooth_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "uniform_edges.hpp"

namespace fpkcheck::transform {
namespace {

constexpr SmoothBins kBins{.first = -0.2, .spacing = 0.2, .count = 8, .from = 0};

TEST(SmoothBins, SumToOne) {
  for (const double t : {0.0, 0.3, 0.5, 0.99}) {
    double sum = 0;
    for (int k = -2; k <= 2; ++k) sum += cardinal_cubic_spline(t - k);
    EXPECT_NEAR(sum, 1, 1e-15);
  }
  EXPECT_EQ(cardinal_cubic_spline(2), 0);
  EXPECT_NEAR(cardinal_cubic_spline(0), 2.0 / 3, 1e-15);
}

TEST(SmoothBins, HaveTheirWeightsInFrontOfTheWall) {
  for (int b = 0; b < kBins.count; ++b) {
    double sum = 0;
    constexpr double kStep = 1e-4;
    for (double y = kStep / 2; y < 3; y += kStep) {
      sum += kStep * cardinal_cubic_spline((y - kBins.first) / kBins.spacing - b);
    }
    EXPECT_NEAR(smooth_bin_weight(kBins, b), sum, 1e-8) << b;
    EXPECT_NEAR(smooth_bin_weight({.first = -0.2, .spacing = 0.2, .count = 8}, b), 0.2, 1e-15);
  }
}

TEST(SmoothBins, AreAsWideAsTheirWeights) {
  const Marginal of_y = smooth_bin_marginal(kBins, std::vector<double>(8, 1.0));
  EXPECT_EQ(of_y.edges.front(), 0);
  EXPECT_NEAR(of_y.bin_width(0), 0.2 / 24, 1e-15);
  EXPECT_NEAR(of_y.bin_width(1), 0.1, 1e-15);
  for (std::size_t b = 3; b < 8; ++b) EXPECT_NEAR(of_y.bin_centre(b), 0.2 * (double(b) - 1), 1e-14);
  const Marginal of_v =
      smooth_bin_marginal({.first = -0.4, .spacing = 0.2, .count = 5}, {1, 2, 3, 4, 5});
  for (std::size_t b = 0; b < 5; ++b)
    EXPECT_NEAR(of_v.bin_centre(b), -0.4 + 0.2 * double(b), 1e-14);
}

/// p(x) = exp(-x) for x > 0, else 0: a bin away from the wall has exp(-centre) (2 sinh(h/2)/h)^4.
TEST(SmoothAverages, OfAnExponentialAreThoseOfTheFormula) {
  for (const auto& [bins, tolerance] : {std::pair{70, 1e-7}, std::pair{140, 1e-8}}) {
    const auto edges = tests::uniform_edges(0, 7, bins);
    Marginal sharp{.edges = edges, .density = {}, .lower = {}, .upper = {}};
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      sharp.density.push_back((std::exp(-edges[k]) - std::exp(-edges[k + 1])) /
                              (edges[k + 1] - edges[k]));
    }
    const Marginal smooth = average_over_smooth_bins(sharp, kBins);
    const double factor = std::pow(2 * std::sinh(0.1) / 0.2, 4);
    for (std::size_t b = 3; b < 8; ++b) {
      EXPECT_NEAR(smooth.density[b], factor * std::exp(-0.2 * (double(b) - 1)), tolerance) << b;
    }
    // Bins at the wall, int_0^1 (1 - t)^3/6 e^-ht dt and similar: by a fine midpoint rule.
    for (int b = 0; b < 3; ++b) {
      double sum = 0;
      constexpr double kStep = 1e-5;
      for (double y = kStep / 2; y < 0.6; y += kStep) {
        sum += kStep * std::exp(-y) * cardinal_cubic_spline(y / 0.2 + 1 - b);
      }
      EXPECT_NEAR(smooth.density[std::size_t(b)], sum / smooth_bin_weight(kBins, b),
                  4 * tolerance + 1e-8);
    }
  }
}

TEST(SmoothAverages, KeepAJumpAtTheWall) {
  // p = 1 for v < 0 and 3 for v > 0: a jump as in densities of y' at the wall.
  Marginal sharp{.edges = tests::uniform_edges(-1, 1, 40), .density = {}, .lower = {}, .upper = {}};
  for (std::size_t k = 0; k < 40; ++k) sharp.density.push_back(k < 20 ? 1 : 3);
  const Marginal smooth =
      average_over_smooth_bins(sharp, {.first = -0.4, .spacing = 0.2, .count = 5});
  // Fractions of M above 0, for the splines centred at -0.2 and -0.4: 1/24 and 0.
  EXPECT_NEAR(smooth.density[0], 1, 1e-12);
  EXPECT_NEAR(smooth.density[1], 1 + 2.0 / 24, 1e-12);
  EXPECT_NEAR(smooth.density[2], 2, 1e-12);
  EXPECT_NEAR(smooth.density[3], 3 - 2.0 / 24, 1e-12);
  EXPECT_NEAR(smooth.density[4], 3, 1e-12);
}

/// The integral of M dF with F(x) = x^a, computed as a sum over equal increments of F.
double mean_of_spike(double a, int bin) {
  double sum = 0;
  constexpr int kPoints = 400000;
  const double end = std::pow(std::max(0.0, kBins.first + (bin + 2) * kBins.spacing), a);
  for (int n = 0; n < kPoints; ++n) {
    const double x = std::pow((n + 0.5) / kPoints * end, 1 / a);
    sum += cardinal_cubic_spline((x - kBins.first) / kBins.spacing - bin);
  }
  return sum * end / kPoints;
}

TEST(SmoothAverages, ResolveASpikeThatNarrowBinsResolve) {
  // p = a x^(a - 1), unbounded at the wall, on bins that shrink towards the wall.
  const double a = 0.3;
  std::vector<double> edges{0};
  for (double x = 1e-6; x < 0.05; x *= 1.3) edges.push_back(x);
  for (double x = 0.06; x < 2.5; x += 0.02) edges.push_back(x);
  Marginal sharp{.edges = edges, .density = {}, .lower = {}, .upper = {}};
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    sharp.density.push_back((std::pow(edges[k + 1], a) - std::pow(edges[k], a)) /
                            (edges[k + 1] - edges[k]));
  }
  const Marginal smooth = average_over_smooth_bins(sharp, kBins);
  for (int b = 0; b < kBins.count; ++b) {
    EXPECT_NEAR(smooth.density[std::size_t(b)] * smooth_bin_weight(kBins, b) / mean_of_spike(a, b),
                1, 1e-5)
        << b;
  }
}

}  // namespace
}  // namespace fpkcheck::transform
