#include "transform/conservative_remap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "transform/joint_density.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::transform {
namespace {

using tests::uniform_edges;

// Exact cell averages of p(y) p(v) from the cumulative distributions.
using Cumulative = double (*)(double);
GridDensity product(Cumulative of_y, Cumulative of_v, std::vector<double> y_edges,
                    std::vector<double> v_edges) {
  GridDensity g{std::move(y_edges), std::move(v_edges), {}};
  for (std::size_t i = 0; i < g.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < g.v_cell_count(); ++j) {
      const double y = g.y_edges[i], y_end = g.y_edges[i + 1];
      const double v = g.v_edges[j], v_end = g.v_edges[j + 1];
      g.averages.push_back((of_y(y_end) - of_y(y)) * (of_v(v_end) - of_v(v)) /
                           ((y_end - y) * (v_end - v)));
    }
  }
  return g;
}

double largest_difference(const GridDensity& a, const GridDensity& b) {
  EXPECT_EQ(a.averages.size(), b.averages.size());
  double largest = 0;
  for (std::size_t k = 0; k < a.averages.size(); ++k) {
    largest = std::max(largest, std::abs(a.averages[k] - b.averages[k]));
  }
  return largest;
}

double bell_cumulative(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }
// p(v) is higher by 1/0.81 above 0 than below, as at a wall of restitution coefficient 0.9.
double jumping_cumulative(double v) {
  const double half = bell_cumulative(v) - 0.5;
  return v < 0 ? half : half / 0.81;
}

TEST(ConservativeRemap, OntoCoincidingEdgesSumsWholeBinsToTheLastDigit) {
  const std::vector<double> source{-2, -1, -0.25, 0, 0.5, 1, 3};
  // Tiny masses beside large masses: a difference of large cumulative masses would lose the digits
  // of the tiny masses.
  const std::vector<double> masses{1e-30, 3e-25, 7, 5, 2e-20, 1e-28};
  EXPECT_EQ(ConservativeRemap(source, source)(masses), masses);
  const std::vector<double> coarse{-2, -0.25, 0, 1, 3};
  EXPECT_EQ(ConservativeRemap(source, coarse)(masses),
            (std::vector<double>{1e-30 + 3e-25, 7, 5 + 2e-20, 1e-28}));
}

TEST(ConservativeRemap, ConservesMassWithinTheSource) {
  const auto source = uniform_edges(-3, 5, 23), target = uniform_edges(-7, 8, 57);
  std::vector<double> masses;
  for (int k = 0; k < 23; ++k) masses.push_back(1 + std::sin(0.4 * k));
  const auto moved = ConservativeRemap(source, target)(masses);
  EXPECT_NEAR(std::accumulate(moved.begin(), moved.end(), 0.0),
              std::accumulate(masses.begin(), masses.end(), 0.0), 1e-13);
  EXPECT_EQ(moved.front(), 0);
  EXPECT_EQ(moved.back(), 0);
  EXPECT_EQ(ConservativeRemap(source, uniform_edges(6, 9, 3))(masses), std::vector<double>(3));
}

TEST(ConservativeRemap, InterpolatesUpToZeroButNotAcross) {
  const auto source = uniform_edges(-8, 8, 16);
  // Value of the polynomial through 0 at seven edges and 1 at the next edge, half a bin before it.
  const double half = 0.5 * 1.5 * 2.5 * 3.5 * 4.5 * 5.5 * 6.5 / (1 * 2 * 3 * 4 * 5 * 6 * 7);
  for (const int side : {-1, 1}) {
    std::vector<double> masses(16);
    masses[side < 0 ? 7 : 8] = 1;
    const auto halves = ConservativeRemap(source, std::vector<double>{-1, -0.5, 0, 0.5, 1})(masses);
    EXPECT_NEAR(halves[side < 0 ? 0 : 3], half, 1e-14);
    EXPECT_NEAR(halves[side < 0 ? 1 : 2], 1 - half, 1e-14);
    EXPECT_EQ(halves[side < 0 ? 2 : 0], 0);
    EXPECT_EQ(halves[side < 0 ? 3 : 1], 0);
  }
}

// A spike on cells that shrink towards it, as for rare impulses: the polynomial overshoots by more
// than the mass of the adjacent bins.
TEST(ConservativeRemap, CreatesNoNegativeMassNextToASpike) {
  std::vector<double> source{0}, masses;
  for (double x = 1e-3; x < 30; x *= 1.25) source.push_back(x);
  for (std::size_t k = 0; k + 1 < source.size(); ++k) masses.push_back(k == 0 ? 0.97 : 1e-4);
  for (const int bins : {7, 40, 300, 5000}) {
    for (const double end : {0.01, 0.5, 20.0}) {
      const auto moved = ConservativeRemap(source, uniform_edges(0, end, bins))(masses);
      double sum = 0, least = 1;
      for (const double mass : moved) {
        sum += mass;
        least = std::min(least, mass);
      }
      EXPECT_GE(least, -1e-6) << bins << " " << end;
      EXPECT_GT(sum, 0.97);
      EXPECT_LT(sum, 0.98);
    }
  }
}

TEST(OnCells, OfAGridConvergesWithOrder7OrMoreAndKeepsTheJumpAtTheWall) {
  const auto y_edges = uniform_edges(0, 6, 31), v_edges = uniform_edges(-6, 6, 34);
  for (const Cumulative of_v : {bell_cumulative, jumping_cumulative}) {
    const GridDensity exact = product(bell_cumulative, of_v, y_edges, v_edges);
    const auto error = [&](int n) {
      const auto source =
          product(bell_cumulative, of_v, uniform_edges(0, 8, n), uniform_edges(-8, 8, 2 * n));
      return largest_difference(average_over_cells(source, y_edges, v_edges), exact);
    };
    const double coarse = error(16), middle = error(32), fine = error(64);
    for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
      EXPECT_GT(order, 6.0) << coarse << " " << middle << " " << fine;
      EXPECT_LT(order, 10.0) << coarse << " " << middle << " " << fine;
    }
  }
}

TEST(OnCells, OfAGridKeepsTheMassThatTheAxesCover) {
  const auto grid = product(bell_cumulative, jumping_cumulative, uniform_edges(0, 8, 20),
                            uniform_edges(-8, 8, 26));
  const auto wider = average_over_cells(grid, uniform_edges(0, 9, 31), uniform_edges(-11, 11, 41));
  EXPECT_NEAR(mass(wider), mass(grid), 1e-13);
  const auto narrower = average_over_cells(grid, uniform_edges(0, 4, 31), uniform_edges(-4, 4, 42));
  EXPECT_NEAR(mass(narrower),
              (bell_cumulative(4) - 0.5) * (jumping_cumulative(4) - jumping_cumulative(-4)), 1e-6);
}

}  // namespace
}  // namespace fpkcheck::transform
