#include <gtest/gtest.h>

#include <cmath>

#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {
namespace {

TEST(Tolerances, CoefficientAndTailToleranceFollowTheDeterministicOne) {
  const BaselineCheckTolerances wide{.deterministic = 1e-6};
  EXPECT_DOUBLE_EQ(wide.coefficient_tolerance(), 5e-5);
  EXPECT_DOUBLE_EQ(wide.tail_tolerance(), 1e-4);
}

TEST(Tolerances, BonferroniThresholdGrowsWithTheNumber) {
  const BaselineCheckTolerances tolerances;
  EXPECT_NEAR(tolerances.bonferroni_threshold(1), 4, 1e-9);
  EXPECT_NEAR(tolerances.bonferroni_threshold(0), 4, 1e-9);
  // erfc(x / sqrt 2) is 6.33e-5 at 4, and a hundredth of it at 4.99.
  const double x = tolerances.bonferroni_threshold(100);
  EXPECT_NEAR(std::erfc(x / std::sqrt(2.0)) * 100, std::erfc(4 / std::sqrt(2.0)), 1e-9);
  EXPECT_GT(x, 4.8);
  EXPECT_TRUE(
      std::isfinite(BaselineCheckTolerances{.standard_errors = 40}.bonferroni_threshold(1000)));
}

using transform::Solution;
using transform::StateVariable;

Solution simulation() {
  Solution one;
  one.moments = {.y2 = 1};
  one.mass = 1;
  one.standard_errors = {.moments = {.y2 = 0.1}};
  one.sampling = {.y = 0.01, .ydot = 0.02, .y_99 = 0.03, .ydot_99 = 0.03};
  return one;
}

TEST(Chance, TheSameSeedGivesIdenticalDigits) {
  Solution other = simulation();
  EXPECT_FALSE(have_independent_sampling_errors(simulation(), other));
  other.moments.v4 = 1e-300;
  EXPECT_TRUE(have_independent_sampling_errors(simulation(), other));
  other = simulation();
  other.standard_errors->moments.y2 = std::nextafter(0.1, 1);
  EXPECT_TRUE(have_independent_sampling_errors(simulation(), other));
  EXPECT_FALSE(have_independent_sampling_errors(Solution{}, other));
}

TEST(Chance, AnL1HasTheStatedSamplingTolerance) {
  const Solution one = simulation();
  CheckedQuantity quantity{.kind = CheckedQuantityKind::distance, .allowed = 1e-8};
  set_tolerance_from_sampling_error(quantity, std::nullopt, StateVariable::y, {});
  Solution silent = one;
  silent.sampling->y_99.reset();
  set_tolerance_from_sampling_error(quantity, silent.sampling, StateVariable::y, {});
  silent.sampling.reset();
  set_tolerance_from_sampling_error(quantity, silent.sampling, StateVariable::y, {});
  EXPECT_EQ(quantity.kind, CheckedQuantityKind::distance);
  EXPECT_EQ(quantity.allowed, 1e-8);
  set_tolerance_from_sampling_error(quantity, one.sampling, StateVariable::ydot, {});
  EXPECT_EQ(quantity.kind, CheckedQuantityKind::simulated_l1);
  EXPECT_EQ(quantity.allowed, 4);
  EXPECT_EQ(quantity.error, 0.02);
  EXPECT_EQ(quantity.quantile_99, 0.03);
}

TEST(Chance, MassHasBinomialStandardError) {
  // The L1 error of a histogram of n samples is at least sqrt(2/(pi n)); one sample has mass 1/n.
  Solution one = simulation();
  const double n = 1e4;
  one.sampling->y = std::sqrt(2 / (3.14159265358979 * n));
  EXPECT_NEAR(standard_error_of_mass(one), 1 / n, 1e-10);
  one.mass = 0.99;
  EXPECT_NEAR(standard_error_of_mass(one), std::sqrt(0.01 / n), 1e-5);
  one.sampling.reset();
  EXPECT_TRUE(std::isnan(standard_error_of_mass(one)));
}

TEST(Chance, ErrorsOfFewStreamsHaveLargerTolerance) {
  Solution few = simulation(), many = simulation();
  few.metrics = transform::SolverMetricsBuilder()
                    .add_result_metric(kStreamsMetric, std::int64_t{16})
                    .take_metrics();
  many.metrics = transform::SolverMetricsBuilder()
                     .add_result_metric(kStreamsMetric, std::int64_t{1024})
                     .take_metrics();
  const BaselineCheckTolerances tolerances;
  const double of_few = standard_error_change_tolerance(few, 1, 1, tolerances);
  const double of_many = standard_error_change_tolerance(many, 1, 1, tolerances);
  const double of_usual = standard_error_change_tolerance(simulation(), 1, 1, tolerances);
  EXPECT_NEAR(of_few, std::exp(1.25 * 4 / std::sqrt(15.0)) - 1, 1e-9);
  EXPECT_GT(of_few, of_usual);
  EXPECT_GT(of_usual, of_many);
  EXPECT_GT(standard_error_change_tolerance(many, 1, 2, tolerances), of_many);
  EXPECT_GT(standard_error_change_tolerance(many, 60, 1, tolerances), of_many);
}

}  // namespace
}  // namespace fpkcheck::check
