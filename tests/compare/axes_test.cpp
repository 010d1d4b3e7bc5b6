#include "compare/comparison_bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::compare {
namespace {

using transform::StateVariable;

problem::Problem with_impulses_per_decay_time(double number) {
  tests::Parameters parameters;
  parameters.rate *= number / problem::impulses_per_decay_time(tests::make_problem(parameters));
  return tests::make_problem(parameters);
}

TEST(ComparisonAxes, AreUniformForBoundedMarginals) {
  const auto axes = comparison_bins(with_impulses_per_decay_time(1.01));
  EXPECT_EQ(axes.divisions, 0);
  for (const StateVariable variable : transform::kVariables) {
    const auto& all = comparison_bin_edges(axes, variable);
    ASSERT_EQ(all.size(), 141u);
    EXPECT_EQ(comparison_bin_edges(undivided_comparison_bins(axes), variable), all);
    const double width = (all.back() - all.front()) / 140;
    for (std::size_t k = 0; k < 140; ++k) EXPECT_NEAR(all[k + 1] - all[k], width, 1e-12 * width);
  }
  EXPECT_EQ(axes.y_edges[0], 0);
  EXPECT_EQ(axes.v_edges[70], 0);
  EXPECT_EQ(axes.v_edges[0], -axes.v_edges[140]);
}

TEST(ComparisonAxes, DivideTheBinsAtASpike) {
  const auto axes = comparison_bins(with_impulses_per_decay_time(0.99));
  ASSERT_EQ(axes.y_edges.size(), 144u);
  ASSERT_EQ(axes.v_edges.size(), 147u);
  const double y_width = axes.y_edges.back() / 140, v_width = axes.v_edges.back() / 70;
  for (const int d : {1, 2, 3}) {
    EXPECT_NEAR(axes.y_edges[static_cast<std::size_t>(4 - d)], y_width / (1 << (2 * d)),
                1e-14 * y_width);
    EXPECT_NEAR(axes.v_edges[static_cast<std::size_t>(77 - d)], v_width / (1 << (2 * d)),
                1e-14 * v_width);
  }
  EXPECT_EQ(axes.v_edges[73], 0);
  for (std::size_t k = 0; k < 147; ++k) EXPECT_EQ(axes.v_edges[k], -axes.v_edges[146 - k]);
  for (const StateVariable variable : transform::kVariables) {
    EXPECT_TRUE(std::ranges::is_sorted(comparison_bin_edges(axes, variable)));
    EXPECT_EQ(comparison_bin_edges(undivided_comparison_bins(axes), variable).size(), 141u);
  }
}

TEST(ComparisonAxes, HaveUniformBinsIndependentOfTheRate) {
  // The rate alone decides where bins are divided; the intensity and the extent are equal.
  const auto rare = comparison_bins(with_impulses_per_decay_time(0.5));
  const auto frequent = comparison_bins(with_impulses_per_decay_time(5));
  for (const StateVariable variable : transform::kVariables) {
    const auto even = comparison_bin_edges(undivided_comparison_bins(rare), variable);
    ASSERT_EQ(even.size(), comparison_bin_edges(frequent, variable).size());
    for (std::size_t k = 0; k < even.size(); ++k) {
      EXPECT_NEAR(even[k], comparison_bin_edges(frequent, variable)[k], 1e-14 * even.back());
    }
  }
}

TEST(ComparisonAxes, MergeDividedBinsByMass) {
  const auto axes = comparison_bins(with_impulses_per_decay_time(0.5));
  for (const StateVariable variable : transform::kVariables) {
    transform::Marginal marginal{comparison_bin_edges(axes, variable), {}, {}, {}};
    for (std::size_t b = 0; b + 1 < marginal.edges.size(); ++b) {
      marginal.density.push_back(1.0 / static_cast<double>(b + 3));
    }
    const auto even = merge_divided_bins(axes, variable, marginal);
    ASSERT_EQ(even.edges, comparison_bin_edges(undivided_comparison_bins(axes), variable));
    ASSERT_EQ(even.size(), 140u);
    const std::size_t below =
        variable == StateVariable::y ? 0 : 69;  // uniform bins before those at 0
    double mass = 0;
    for (std::size_t b = below; b < below + 4; ++b)
      mass += marginal.density[b] * marginal.bin_width(b);
    EXPECT_NEAR(even.density[below] * even.bin_width(below), mass, 1e-15);
    EXPECT_TRUE(even.lower.empty());
    EXPECT_NEAR(even.density.back(), marginal.density.back(), 1e-15);
    EXPECT_NEAR(even.density[140 - 2], marginal.density[marginal.size() - 2], 1e-15);
  }
}

TEST(ComparisonAxes, MergeIntervalsForIndependentErrors) {
  const ComparisonBins axes{{0, 1, 4, 8}, {}, 1};
  const transform::Marginal marginal{axes.y_edges, {5, 1, 2}, {2, 0, 1}, {8, 3, 2.5}};
  const auto even = merge_divided_bins(axes, StateVariable::y, marginal);
  EXPECT_EQ(even.edges, (std::vector<double>{0, 4, 8}));
  EXPECT_EQ(even.density, (std::vector<double>{2, 2}));
  EXPECT_NEAR(even.lower[0], 2 - std::hypot(3, 3) / 4, 1e-15);  // parts of width 1 and 3
  EXPECT_NEAR(even.upper[0], 2 + std::hypot(3, 6) / 4, 1e-15);
  EXPECT_NEAR(even.lower[1], 1, 1e-15);
  EXPECT_NEAR(even.upper[1], 2.5, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::compare
