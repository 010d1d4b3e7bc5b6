#include "compare/study/richardson.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::compare {
namespace {

constexpr double kRatio = 1.4142135623730951;

// u(h) = limit + error h^order, with an error that changes its sign over the bins.
Marginals at(double h, double order, double error = 0.1) {
  const double scale = error * std::pow(h, order);
  const auto marginal = [&](double level) {
    return transform::Marginal{
        {0, 1, 2, 3}, {level + scale, level - 2 * scale, level + 0.5 * scale}, {}, {}};
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

TEST(Richardson, FindsTheLimitOfASequenceOfItsOrder) {
  const auto limit = richardson_limit(at(1, 3), at(1 / kRatio, 3), at(0.5, 3), kRatio, 5);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(limit.value.y.density[k], 0.3, 1e-13);
    EXPECT_NEAR(limit.value.ydot.density[k], 0.2, 1e-13);
  }
  EXPECT_NEAR(limit.value.moments.y2, 2, 1e-13);
  EXPECT_NEAR(limit.value.moments.y4, 3, 1e-13);
  EXPECT_NEAR(limit.value.moments.v4, 6, 1e-13);
  EXPECT_NEAR(limit.error.y4, 4 * 0.1 / 8, 1e-13);  // the error of the finest level
}

TEST(Richardson, SeesTheOrderOfASequence) {
  for (const double order : {1.0, 2.0, 3.5, 7.0}) {
    const auto orders =
        observed_orders(at(1, order), at(1 / kRatio, order), at(0.5, order), kRatio);
    EXPECT_NEAR(orders.l1, order, 1e-9);
    EXPECT_NEAR(orders.y2, order, 1e-9);
    EXPECT_NEAR(orders.v2, order, 1e-9);
  }
}

// A moment that happens to be the same on the last two levels is not known exactly.
TEST(Richardson, DoesNotTakeAChanceAgreementOfMomentsForAccuracy) {
  auto fine = at(0.5, 3);
  fine.moments.y2 = at(1 / kRatio, 3).moments.y2;
  const auto limit = richardson_limit(at(1, 3), at(1 / kRatio, 3), fine, kRatio, 5);
  EXPECT_NEAR(limit.error.y2, 0.1 / 8, 1e-12);  // what a sequence of this order would have
}

// Differences that fall faster than the scheme can are chance: the limit must not be overrated.
TEST(Richardson, DoesNotExtrapolateByMoreThanTheSchemeHas) {
  const auto coarse = at(1, 7), middle = at(1 / kRatio, 7), fine = at(0.5, 7);
  const auto limit = richardson_limit(coarse, middle, fine, kRatio, 2);
  const double step = fine.moments.y2 - middle.moments.y2;
  EXPECT_NEAR(limit.value.moments.y2, fine.moments.y2 + step, 1e-13);  // 1 / (sqrt(2)^2 - 1) = 1
}

TEST(Richardson, DoesNotExtrapolateASequenceThatDoesNotConvergeBeyondFirstOrder) {
  const auto limit = richardson_limit(at(0.5, 3), at(1 / kRatio, 3), at(1, 3), kRatio, 5);
  const double step = at(1, 3).moments.y2 - at(1 / kRatio, 3).moments.y2;
  EXPECT_NEAR(limit.value.moments.y2, at(1, 3).moments.y2 + step / (kRatio - 1), 1e-12);
}

}  // namespace
}  // namespace fpkcheck::compare
