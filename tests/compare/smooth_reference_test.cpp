#include "compare/smooth_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "compare/distances.hpp"
#include "compare/solution_assessment.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using transform::StateVariable;

TEST(SmoothReference, IsTheSimulationWithSmoothEstimates) {
  auto one = tests::made_up_case_with_control_variates();
  auto& simulation = one.solutions.back();
  EXPECT_EQ(find_smooth_reference(one.solutions), &simulation);
  simulation.identity.equation = problem::DensityEquation::white;
  EXPECT_EQ(find_smooth_reference(one.solutions), nullptr);
  simulation.identity.equation = problem::DensityEquation::kf;
  simulation.status = transform::Status::failed;
  EXPECT_EQ(find_smooth_reference(one.solutions), nullptr);
  EXPECT_EQ(find_smooth_reference(tests::made_up_case().solutions), nullptr);
}

TEST(SmoothReference, IsTheReferenceByItsSmoothSamplingError) {
  auto one = tests::made_up_case_with_control_variates();
  auto& kf = one.solutions[6];
  kf.error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  one.update_assessment();
  EXPECT_EQ(one.assessment.reference, "mcs");
  EXPECT_EQ(l1_error_estimate(one.solutions.back(), StateVariable::y), 3e-6);
  kf.error = {.y_l1 = 1e-6, .ydot_l1 = 1e-6};
  one.update_assessment();
  EXPECT_EQ(one.assessment.reference, "fd-kf");
}

// Fully correlated errors: the signs of the differences decide which errors add and which cancel.
TEST(SmoothReference, HasStandardErrorsThatDependOnTheSignsOfDifferences) {
  const transform::SmoothBins bins{.first = 0, .spacing = 1, .count = 3};
  const transform::SmoothBinEstimate estimate{
      .bins = bins,
      .averages = transform::smooth_bin_marginal(bins, {1, 1, 1}),
      // Standard errors .1, .2, .3, with correlation 1.
      .covariance = {.01, .02, .03, .02, .04, .06, .03, .06, .09}};
  const auto error = [&](std::vector<double> averages) {
    return l1_standard_error(transform::smooth_bin_marginal(bins, std::move(averages)), estimate);
  };
  EXPECT_NEAR(error({2, 2, 2}), 0.6, 1e-12);
  EXPECT_NEAR(error({2, 2, 0}), 0.0, 1e-7);
  EXPECT_NEAR(error({0, 2, 2}), 0.4, 1e-12);
}

TEST(SmoothReference, HasDistancesOverSmoothBins) {
  constexpr double kError = 1e-6;
  const auto one = tests::made_up_case_with_control_variates(kError);
  const auto plain = tests::made_up_case();
  for (const auto variable : transform::kVariables) {
    const auto* pair = find_pair_distances(one.pairs, "fd-kf", "mcs", variable);
    // The same density except for errors of kError in every second bin.
    const auto& averages =
        transform::find_smooth_bin_estimate(one.solutions.back(), variable)->averages;
    double expected = 0, variance = 0;
    for (std::size_t b = 0; b < averages.size(); ++b) {
      expected += b % 2 == 0 ? averages.bin_width(b) * kError : 0;
      variance += std::pow(averages.bin_width(b) * kError, 2);
    }
    EXPECT_NEAR(pair->distances.l1, expected, 0.01 * expected);
    EXPECT_NEAR(*pair->l1_standard_error, std::sqrt(variance), 1e-12);
    // The sampling noise of the histogram.
    EXPECT_GT(*l1_distance_between(plain.pairs, "fd-kf", "mcs", variable), 100 * expected);
    // Distances between the other solutions do not change.
    EXPECT_EQ(*l1_distance_between(one.pairs, "fd-white", "fd-kf", variable),
              *l1_distance_between(plain.pairs, "fd-white", "fd-kf", variable));
    EXPECT_FALSE(find_pair_distances(one.pairs, "fd-white", "fd-kf", variable)->l1_standard_error);
  }
}

// A solution with a sampling error over sharp bins is compared over sharp bins.
TEST(SmoothReference, HasDistancesOverSharpBinsToNoisySolutions) {
  auto one = tests::made_up_case_with_control_variates();
  auto solutions = one.solutions;
  solutions[5].sampling = {.y = 1e-3, .ydot = 1e-3};  // fd-km4, as if from a file
  const auto compared = compare_solutions(comparison_bins(one.problem), solutions);
  EXPECT_FALSE(
      find_pair_distances(compared.pairs, "fd-km4", "mcs", StateVariable::y)->l1_standard_error);
  EXPECT_EQ(*l1_distance_between(compared.pairs, "fd-km4", "mcs", StateVariable::y),
            *l1_distance_between(tests::made_up_case().pairs, "fd-km4", "mcs", StateVariable::y));
  EXPECT_TRUE(
      find_pair_distances(compared.pairs, "fd-kf", "mcs", StateVariable::y)->l1_standard_error);
}

TEST(SmoothReference, EndsTheChainWithTheDiscretisation) {
  const auto one = tests::made_up_case_with_control_variates();
  ASSERT_FALSE(one.budget.empty());
  for (const auto& row : one.budget) {
    const auto& last = row.parts.back();
    EXPECT_EQ(last.error_budget_part_name(), "discretisation");
    EXPECT_EQ(last.from, "fd-kf");
    EXPECT_EQ(last.to, "mcs");
    EXPECT_EQ(last.l1, *l1_distance_between(one.pairs, "fd-kf", "mcs", row.variable));
    EXPECT_EQ(last.standard_error,
              find_pair_distances(one.pairs, "fd-kf", "mcs", row.variable)->l1_standard_error);
    EXPECT_EQ(*last.quantile_99, row.variable == StateVariable::y ? 5e-6 : 6e-6);
    double sum = 0;
    for (const auto& part : row.parts) sum += part.l1;
    EXPECT_LE(row.total, sum * (1 + 1e-12));
    EXPECT_EQ(row.total, *l1_distance_between(one.pairs, row.solution, "mcs", row.variable));
  }
}

}  // namespace
}  // namespace fpkcheck::compare
