#include "transform/marginal_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "transform/solution.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::transform {
namespace {

using tests::uniform_edges;

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// Half-normal in y times N(0.3, 1) in v, as exact cell averages.
GridDensity bell(int ny, int nv) {
  GridDensity g{uniform_edges(0, 8, ny), uniform_edges(-8, 8, nv), {}};
  for (int i = 0; i < ny; ++i) {
    for (int j = 0; j < nv; ++j) {
      const double dy = 2 * (normal_cdf(g.y_edges[i + 1]) - normal_cdf(g.y_edges[i]));
      const double dv = normal_cdf(g.v_edges[j + 1] - 0.3) - normal_cdf(g.v_edges[j] - 0.3);
      g.averages.push_back(dy * dv / ((8.0 / ny) * (16.0 / nv)));
    }
  }
  return g;
}

TEST(Marginal, OfAGridOnItsOwnEdgesIsExact) {
  const GridDensity g = bell(16, 32);
  const Marginal y = marginal(g, StateVariable::y, g.y_edges);
  const Marginal v = marginal(g, StateVariable::ydot, g.v_edges);
  EXPECT_NEAR(y.density[3], 2 * (normal_cdf(2.0) - normal_cdf(1.5)) / 0.5, 1e-14);
  EXPECT_NEAR(v.density[20], (normal_cdf(2.5 - 0.3) - normal_cdf(2.0 - 0.3)) / 0.5, 1e-14);
}

TEST(Marginal, BetweenTheEdgesConvergesWithOrder8InTheGrid) {
  const auto edges = uniform_edges(0, 6, 97);
  const auto error = [&](int n) {
    const Marginal m = marginal(bell(n, 8), StateVariable::y, edges);
    double largest = 0;
    for (std::size_t b = 0; b < m.size(); ++b) {
      const double exact = 2 * (normal_cdf(edges[b + 1]) - normal_cdf(edges[b])) / m.bin_width(b);
      largest = std::max(largest, std::abs(m.density[b] - exact));
    }
    return largest;
  };
  const double coarse = error(16), middle = error(32), fine = error(64);
  for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
    EXPECT_GT(order, 6.0) << coarse << " " << middle << " " << fine;
    EXPECT_LT(order, 9.5) << coarse << " " << middle << " " << fine;
  }
}

TEST(Marginal, BinsBeyondTheGridAreEmptyAndMassIsConserved) {
  const auto edges = uniform_edges(-20, 20, 133);
  const Marginal m = marginal(bell(16, 64), StateVariable::ydot, edges);
  double sum = 0;
  for (std::size_t b = 0; b < m.size(); ++b) sum += m.density[b] * m.bin_width(b);
  EXPECT_EQ(m.density.front(), 0.0);
  EXPECT_EQ(m.density.back(), 0.0);
  EXPECT_NEAR(sum, mass(bell(16, 64)), 1e-13);
}

TEST(Marginal, UsesTheSolversEstimateOnItsEdges) {
  Solution s;
  s.density = bell(16, 16);
  Marginal estimate{.edges = {0, 1, 2}, .density = {7, 8}, .lower = {6, 7}, .upper = {8, 9}};
  s.estimated_marginals.emplace_back(StateVariable::y, estimate);
  EXPECT_EQ(marginal(s, StateVariable::y, estimate.edges).lower, estimate.lower);
  EXPECT_TRUE(marginal(s, StateVariable::ydot, estimate.edges).lower.empty());
  EXPECT_TRUE(marginal(s, StateVariable::y, std::vector<double>{0, 1}).lower.empty());
}

TEST(Marginal, ThrowsWithoutADensity) {
  EXPECT_THROW(marginal(Solution{}, StateVariable::y, std::vector<double>{0, 1}), std::logic_error);
}

TEST(Marginal, L1DistanceIsTheAreaBetweenTwoOnTheSameBins) {
  const Marginal a{{0, 1, 3}, {0.4, 0.3}, {}, {}}, b{{0, 1, 3}, {0.6, 0.2}, {}, {}};
  EXPECT_DOUBLE_EQ(l1_distance(a, b), 0.2 + 2 * 0.1);
  EXPECT_EQ(l1_distance(a, a), 0);
  EXPECT_THROW(l1_distance(a, {{0, 2, 3}, {0.6, 0.2}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(l1_distance(a, {{0, 1, 3}, {0.6}, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace fpkcheck::transform
