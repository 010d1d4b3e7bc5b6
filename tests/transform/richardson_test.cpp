#include "transform/richardson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fpkcheck::transform {
namespace {

// u(h) = limit + error h^order; the sign of the error varies over the bins.
GridLevelSolution at(double h, double order, double error = 0.1) {
  const double scale = error * std::pow(h, order);
  const auto marginal = [&](double level) {
    return Marginal{{0, 1, 2, 3}, {level + scale, level - 2 * scale, level + 0.5 * scale}, {}, {}};
  };
  return {marginal(0.3),
          marginal(0.2),
          {.y1 = 1 + scale,
           .y2 = 2 - scale,
           .y4 = 3 + 4 * scale,
           .v1 = 0,
           .v2 = 5 + scale,
           .v4 = 6 + scale}};
}

struct Sequence {
  GridLevelSolution coarse, middle, fine;

  GridLevelDifference before() const { return grid_level_difference(coarse, middle); }
  GridLevelDifference last() const { return grid_level_difference(middle, fine); }
  RichardsonEstimate richardson_estimate(int order_of_scheme) const {
    return transform::richardson_estimate(before(), last(), kRefinementRatio, order_of_scheme);
  }
};

Sequence of_order(double order) {
  return {at(1, order), at(1 / kRefinementRatio, order), at(0.5, order)};
}

TEST(Richardson, FindsTheLimitOfASequenceOfKnownOrder) {
  const Sequence levels = of_order(3);
  const RichardsonEstimate known = levels.richardson_estimate(5);
  const GridLevelSolution found = richardson_limit(levels.middle, levels.fine, known.factor);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.y.density[k], 0.3, 1e-13);
    EXPECT_NEAR(found.ydot.density[k], 0.2, 1e-13);
  }
  EXPECT_NEAR(found.moments.y2, 2, 1e-13);
  EXPECT_NEAR(found.moments.y4, 3, 1e-13);
  EXPECT_NEAR(found.moments.v4, 6, 1e-13);
  // The exact errors of the finest grid level.
  EXPECT_NEAR(known.error.moments.y4, 4 * 0.1 / 8, 1e-13);
  EXPECT_NEAR(known.error.y_l1, l1_distance(levels.fine.y, found.y), 1e-13);
  EXPECT_NEAR(known.error.ydot_l1, 3.5 * 0.1 / 8, 1e-13);
}

TEST(Richardson, ObservesTheOrderOfASequence) {
  for (const double order : {1.0, 2.0, 3.5, 7.0}) {
    const Sequence levels = of_order(order);
    const auto orders =
        observed_convergence_orders(levels.before(), levels.last(), kRefinementRatio);
    EXPECT_NEAR(orders.l1, order, 1e-9);
    EXPECT_NEAR(orders.y2, order, 1e-9);
    EXPECT_NEAR(orders.v2, order, 1e-9);
    EXPECT_EQ(levels.richardson_estimate(9).orders.l1, orders.l1);
  }
}

// A moment with equal values on the last two levels still has an error.
TEST(Richardson, DoesNotTreatAccidentalAgreementAsAccuracy) {
  Sequence levels = of_order(3);
  levels.fine.moments.y2 = levels.middle.moments.y2;
  // The error estimate of a sequence that converges with this order.
  EXPECT_NEAR(levels.richardson_estimate(5).error.moments.y2, 0.1 / 8, 1e-12);
}

// Differences that decrease faster than the scheme allows must not enlarge the extrapolation.
TEST(Richardson, LimitsTheExtrapolationByTheOrderOfTheScheme) {
  EXPECT_NEAR(of_order(7).richardson_estimate(2).factor, 1, 1e-13);  // 1 / (sqrt(2)^2 - 1)
}

TEST(Richardson, UsesACredibleOrderForErrors) {
  EXPECT_EQ(credible_convergence_order(4.5, 5), 4.5);
  EXPECT_EQ(credible_convergence_order(5 + kMaxOrderExcess, 5), 5);
  EXPECT_NEAR(credible_convergence_order(7 + kMaxOrderExcess, 5), 3, 1e-12);
  EXPECT_EQ(credible_convergence_order(22.4, 2), 1);
  EXPECT_EQ(credible_convergence_order(-3, 5), 1);
  // The error of the coarsest level is far too large: the differences decrease too fast.
  Sequence levels = of_order(3);
  levels.coarse = at(1, 3, 3);
  const RichardsonEstimate known = levels.richardson_estimate(3);
  EXPECT_GT(known.orders.l1, 3 + kMaxOrderExcess + 2);
  EXPECT_GE(known.error.y_l1, levels.last().y_l1 / (kRefinementRatio - 1) * (1 - 1e-12));
  EXPECT_FALSE(has_richardson_limit(known.orders.l1, 3));
  EXPECT_TRUE(has_richardson_limit(3, 3));
  EXPECT_FALSE(has_richardson_limit(1, 3));
}

TEST(Richardson, DoesNotExtrapolateASequenceThatDoesNotConvergeBeyondFirstOrder) {
  const Sequence diverging{at(0.5, 3), at(1 / kRefinementRatio, 3), at(1, 3)};
  EXPECT_NEAR(diverging.richardson_estimate(5).factor, 1 / (kRefinementRatio - 1), 1e-12);
  EXPECT_LT(diverging.richardson_estimate(5).orders.l1, 0);
}

// Consecutive levels need common bins; another pair of levels may have other bins.
TEST(Richardson, ComparesConsecutiveLevelsOnCommonBins) {
  GridLevelSolution coarse = at(1, 3);
  coarse.y.edges = {0, 2, 4, 6};
  EXPECT_THROW(grid_level_difference(coarse, at(0.5, 3)), std::invalid_argument);
  GridLevelSolution middle = at(1 / kRefinementRatio, 3);
  middle.y.edges = coarse.y.edges;
  EXPECT_NEAR(grid_level_difference(coarse, middle).y_l1,
              2 * grid_level_difference(at(1, 3), at(1 / kRefinementRatio, 3)).y_l1, 1e-14);
}

// Rest atoms at different walls have different y, but all rest atoms have y' = 0.
TEST(Richardson, ProbabilitiesOfRestAreComparedAndHaveAnError) {
  const auto with_atoms = [](double h) {
    GridLevelSolution level = at(h, 2);
    level.rest_probabilities = {0.25 + 0.01 * h * h, 0.125 - 0.004 * h * h};
    return level;
  };
  const GridLevelSolution coarse = with_atoms(1), middle = with_atoms(1 / kRefinementRatio),
                          fine = with_atoms(0.5);
  const GridLevelDifference last = grid_level_difference(middle, fine);
  const GridLevelDifference plain = grid_level_difference(at(1 / kRefinementRatio, 2), at(0.5, 2));
  ASSERT_EQ(last.rest_probabilities.size(), 2u);
  EXPECT_NEAR(last.rest_probabilities[0], -0.0025, 1e-15);
  EXPECT_NEAR(last.rest_probabilities[1], 0.001, 1e-15);
  EXPECT_NEAR(last.y_l1 - plain.y_l1, 0.0035, 1e-15);
  EXPECT_NEAR(last.ydot_l1 - plain.ydot_l1, 0.0015, 1e-15);
  const RichardsonEstimate known =
      richardson_estimate(grid_level_difference(coarse, middle), last, kRefinementRatio, 2);
  EXPECT_NEAR(known.rest_probabilities[0], 0.0025,
              1e-12);  // second order: the error is the last difference
  EXPECT_NEAR(known.rest_probabilities[1], 0.001, 1e-12);
  EXPECT_THROW(grid_level_difference(at(1, 2), fine), std::invalid_argument);
}

TEST(Richardson, GridLevelIsTakenFromASolution) {
  Solution solution;
  solution.density = GridDensity{{0, 1, 2}, {-1, 0, 1}, {0.1, 0.2, 0.3, 0.4}};
  solution.moments.y2 = 7;
  solution.atoms = {{.y = 0, .probability = 0.25}};
  const GridLevelSolution of =
      make_grid_level(solution, std::vector<double>{0, 1, 2}, std::vector<double>{-1, 0, 1});
  EXPECT_NEAR(of.y.density[1], 0.7, 1e-15);
  EXPECT_NEAR(of.ydot.density[0], 0.4, 1e-15);
  EXPECT_EQ(of.moments.y2, 7);
  EXPECT_EQ(of.rest_probabilities, std::vector<double>{0.25});
}

// The differences of the first two quantities decrease by the factor 2^3. The third quantity has an
// infinite magnitude and therefore no effect on the common order.
TEST(Richardson, ErrorsWithACommonOrderFollowFromTheSumOfTheDifferences) {
  const double last[] = {0.01, 0.2, 1}, before[] = {0.08, 1.6, 1}, scales[] = {1, 10, HUGE_VAL};
  const auto errors = errors_with_common_order(before, last, scales, 2, 5);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR(errors[0], kErrorSafetyFactor * 0.01 / 7, 1e-12);
  EXPECT_NEAR(errors[1], kErrorSafetyFactor * 0.2 / 7, 1e-12);
  EXPECT_NEAR(errors[2], kErrorSafetyFactor * 1.0 / 7, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::transform
