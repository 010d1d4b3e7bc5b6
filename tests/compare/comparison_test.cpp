#include "compare/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::Solution;
using transform::StateVariable;

struct MadeUp {
  ComparisonBins axes = comparison_bins(tests::paper_case(1));
  std::vector<Solution> solutions = tests::made_up_solutions(axes);
  SolutionComparison comparison = compare_solutions(axes, solutions);
};

TEST(Comparison, ContainsEveryPairOfSolutionsWithADensity) {
  const auto [axes, solutions, comparison] = MadeUp();
  // Seven of the eight solutions have a density.
  EXPECT_EQ(comparison.marginals.size(), 2 * 7u);
  ASSERT_EQ(comparison.pairs.size(), 2 * 21u);
  EXPECT_EQ(comparison.pairs.front().a, "epc-gaussian-n2");
  EXPECT_EQ(comparison.pairs.front().b, "epc-gaussian-n4");
  EXPECT_EQ(comparison.pairs.front().variable, StateVariable::y);
  EXPECT_EQ(comparison.pairs.back().a, "fd-kf");
  EXPECT_EQ(comparison.pairs.back().b, "mcs");
  EXPECT_EQ(comparison.pairs.back().variable, StateVariable::ydot);
  const auto& white = comparison.marginals[3];
  const auto& kf = comparison.marginals[5];
  ASSERT_EQ(white.solution + kf.solution, "fd-whitefd-kf");
  const auto* pair = find_pair_distances(comparison.pairs, "fd-kf", "fd-white", StateVariable::y);
  ASSERT_NE(pair, nullptr);
  EXPECT_EQ(pair->distances.kl, compute_distances(white.marginal, kf.marginal).kl);
  EXPECT_NE(pair->distances.kl, compute_distances(kf.marginal, white.marginal).kl);
}

TEST(Comparison, ContainsSolutionsThatAreNotOk) {
  const auto [axes, solutions, comparison] = MadeUp();
  ASSERT_EQ(solutions[1].status, transform::Status::inadmissible);
  EXPECT_EQ(comparison.marginals[1].solution, solutions[1].id());
}

TEST(Comparison, UsesTheHistogramOfTheSimulation) {
  const auto [axes, solutions, comparison] = MadeUp();
  const auto& own = solutions.back().estimated_marginals.front().second;
  const auto& used = comparison.marginals[6];
  ASSERT_EQ(used.solution, "mcs");
  EXPECT_EQ(used.marginal.density, own.density);
  EXPECT_EQ(used.marginal.lower, own.lower);
}

// Rounding makes a discretised tail negative. Solutions that are not ok keep the negative values.
TEST(Comparison, ClipsNegativeDensitiesOfOkSolutions) {
  const auto axes = comparison_bins(tests::paper_case(1));
  auto solutions = tests::made_up_solutions(axes);
  const auto find = [](const std::vector<SolutionMarginalDensity>& marginals,
                       const std::string& id) {
    return std::ranges::find_if(marginals, [&](const auto& one) {
      return one.solution == id && one.variable == StateVariable::y;
    });
  };
  const auto kf = std::ranges::find(solutions, "fd-kf", [](const Solution& s) { return s.id(); });
  ASSERT_NE(kf, solutions.end());
  kf->estimated_marginals.clear();
  transform::GridDensity density{axes.y_edges, axes.v_edges, {}};
  density.averages.assign(density.y_cell_count() * density.v_cell_count(), 1e-3);
  for (std::size_t j = 0; j < density.v_cell_count(); ++j)
    density.averages[20 * density.v_cell_count() + j] = -1e-9;
  kf->density = density;
  for (const auto status : {transform::Status::ok, transform::Status::inadmissible}) {
    kf->status = status;
    const auto comparison = compare_solutions(axes, solutions);
    const double least = find(comparison.marginals, "fd-kf")->marginal.density[20];
    if (status == transform::Status::ok) {
      EXPECT_EQ(least, 0);
    } else {
      EXPECT_LT(least, 0);
    }
  }
}

TEST(Comparison, UsesUniformBinsForDistances) {
  const auto axes = comparison_bins(tests::make_problem({.rate = 0.02}));
  ASSERT_GT(axes.divisions, 0);
  const auto comparison = compare_solutions(axes, tests::made_up_solutions(axes));
  const auto& one = comparison.marginals[0];
  const auto& other = comparison.marginals[2];
  ASSERT_EQ(one.variable, StateVariable::y);
  EXPECT_EQ(one.marginal.edges, axes.y_edges);  // output keeps the divided bins
  const auto* pair =
      find_pair_distances(comparison.pairs, one.solution, other.solution, StateVariable::y);
  ASSERT_NE(pair, nullptr);
  EXPECT_EQ(pair->distances.l1,
            transform::l1_distance(merge_divided_bins(axes, StateVariable::y, one.marginal),
                                   merge_divided_bins(axes, StateVariable::y, other.marginal)));
}

TEST(Comparison, ComparesTheMarginalOfTheNamedVariable) {
  // Two solutions with the same p(y) and different p(y').
  std::vector<Solution> two;
  for (const double quartic : {0.0, 0.1}) {
    two.push_back(tests::solution(tests::identity(quartic > 0 ? "flat" : "normal", "fd",
                                                  DensityEquation::kf, ImpactCondition::map),
                                  tests::smooth_density({2, 0, 2, quartic}, 5, 5)));
  }
  const auto pairs = compare_solutions(comparison_bins(tests::paper_case(1)), two).pairs;
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_LT(pairs[0].distances.l1, 1e-9);
  EXPECT_GT(pairs[1].distances.l1, 1e-2);
}

TEST(Comparison, PairsAreSymmetricAndEmptyWithoutADensity) {
  auto made_up = MadeUp();
  const auto& pairs = made_up.comparison.pairs;
  EXPECT_EQ(l1_distance_between(pairs, "mcs", "fd-kf", StateVariable::y),
            l1_distance_between(pairs, "fd-kf", "mcs", StateVariable::y));
  EXPECT_FALSE(l1_distance_between(pairs, "mcs", "epc-gaussian-n8", StateVariable::y));
  made_up.comparison.pairs.back().distances.l1 = std::nan("");
  EXPECT_FALSE(l1_distance_between(pairs, "mcs", "fd-kf", StateVariable::ydot));
}

}  // namespace
}  // namespace fpkcheck::compare
