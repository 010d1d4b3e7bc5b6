#include "compare/agreement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/distances.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::StateVariable;

Solution solution_named(const char* id) {
  Solution one;
  one.identity.id = id;
  return one;
}

std::vector<SolutionPairDistances> pairs_apart(double y, double ydot) {
  std::vector<SolutionPairDistances> pairs{
      {.a = "a", .b = "b", .variable = StateVariable::y, .distances = {}},
      {.a = "a", .b = "b", .variable = StateVariable::ydot, .distances = {}}};
  pairs[0].distances.l1 = y;
  pairs[1].distances.l1 = ydot;
  return pairs;
}

// For |N|, N standard normal, the S-inequality is an equality.
TEST(Agreement, HasItsNominalSignificanceLevel) {
  const boost::math::normal normal;
  const double quantile_99 = boost::math::quantile(normal, 0.995);
  const double beyond = 2 * boost::math::cdf(boost::math::complement(
                                normal, critical_sampling_l1_distance(quantile_99)));
  EXPECT_NEAR(2 * beyond, kAgreementSignificance, 1e-6);
}

// L1 norms of Gaussian vectors with one to many modes exceed the limit at most at the stated level.
TEST(Agreement, BoundsTheSamplingL1ForAnyNumberOfModes) {
  boost::random::mt19937_64 engine(1);
  boost::random::normal_distribution<double> normal;
  constexpr std::size_t kRuns = 200000;
  for (const int modes : {1, 2, 8}) {
    std::vector<double> norms(kRuns);
    for (double& norm : norms) {
      for (int k = 0; k < modes; ++k) norm += std::abs(normal(engine)) / (1 + k);
    }
    std::ranges::sort(norms);
    const double limit = critical_sampling_l1_distance(norms[kRuns * 99 / 100]);
    const auto beyond = static_cast<double>(norms.end() - std::ranges::upper_bound(norms, limit));
    const double allowed = kAgreementSignificance / 2 * kRuns;
    EXPECT_LT(beyond, allowed + 4 * std::sqrt(allowed)) << modes;
  }
}

// Values of `fpkcheck run case1 --set system.damping=0` with one of six seeds.
TEST(Agreement, AcceptsADistanceAtThe99PercentQuantile) {
  Solution one = solution_named("a"), other = solution_named("b");
  one.error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  other.sampling = {.y = 0.0013, .ydot = 0.0014, .y_99 = 0.0023, .ydot_99 = 0.0027};
  EXPECT_TRUE(solutions_agree(one, other, pairs_apart(0.0023, 0.0028)));
  EXPECT_TRUE(solutions_agree(other, one, pairs_apart(0.0023, 0.0028)));
  EXPECT_FALSE(solutions_agree(one, other, pairs_apart(0.0023, 0.0037)));
  EXPECT_FALSE(solutions_agree(one, other, pairs_apart(0.0032, 0.0028)));
}

TEST(Agreement, AddsTheErrorEstimatesOfBothSolutions) {
  Solution one = solution_named("a"), other = solution_named("b");
  EXPECT_FALSE(largest_explained_l1_distance(one, other, StateVariable::y, false));
  EXPECT_TRUE(solutions_agree(one, other, pairs_apart(1, 1)));  // both without error estimates
  one.sampling = {.y = 3e-3, .ydot = 3e-3, .y_99 = 4e-3, .ydot_99 = 6e-3};
  other.sampling = {.y = 1e-3, .ydot = 4e-3, .y_99 = 3e-3};
  EXPECT_DOUBLE_EQ(*largest_explained_l1_distance(one, other, StateVariable::y, false),
                   critical_sampling_l1_distance(5e-3));
  EXPECT_DOUBLE_EQ(*largest_explained_l1_distance(one, other, StateVariable::ydot, false),
                   critical_sampling_l1_distance(1e-2));
  other.error = {.y_l1 = 8e-3, .ydot_l1 = 0};
  EXPECT_DOUBLE_EQ(*largest_explained_l1_distance(one, other, StateVariable::y, false),
                   critical_sampling_l1_distance(5e-3) + 1e-2);
}

TEST(Agreement, OverSmoothBinsRequiresBothErrorEstimates) {
  Solution one = solution_named("a"), measure = solution_named("b");
  measure.sampling = {.y = 1e-3, .ydot = 1e-3, .y_99 = 2e-3, .ydot_99 = 2e-3};
  measure.smooth_sampling = {.y = 3e-6, .ydot = 4e-6, .y_99 = 5e-6, .ydot_99 = 6e-6};
  auto pairs = pairs_apart(1e-4, 1e-4);
  for (auto& pair : pairs) pair.l1_standard_error = 1e-6;
  EXPECT_TRUE(solutions_agree(one, measure, pairs));
  one.error = {.y_l1 = 2e-5, .ydot_l1 = 2e-5};
  EXPECT_FALSE(solutions_agree(one, measure, pairs));
  one.error = {.y_l1 = 1e-4, .ydot_l1 = 1e-4};
  EXPECT_TRUE(solutions_agree(one, measure, pairs));
}

}  // namespace
}  // namespace fpkcheck::compare
