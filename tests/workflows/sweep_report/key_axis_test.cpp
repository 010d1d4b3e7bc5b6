#include "workflows/sweep/report/figure/key_axis.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"
#include "shown_figure.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

SweepParameterAxis axis_of(const tests::KeyAndValues& axis) {
  return {tests::made_up_plan({axis}), 0};
}

TEST(KeyAxis, IsLogarithmicForLogarithmicSpacing) {
  const auto even = axis_of(tests::kFiveRestitutions).figure_axis();
  EXPECT_FALSE(even.is_logarithmic);
  EXPECT_EQ(even.label, "system.restitution, {/:Italic r}");
  const auto by_decades = axis_of(tests::kThreeRates).figure_axis();
  EXPECT_TRUE(by_decades.is_logarithmic);
  EXPECT_TRUE(tests::tics_of(by_decades).starts_with("0.1 0.1, "));
  EXPECT_TRUE(tests::tics_of(by_decades).ends_with(", 10 10"));
  EXPECT_TRUE(axis_of({"impulse.rate", "0.1,1,10"}).is_logarithmic());
  EXPECT_FALSE(axis_of({"impulse.rate", "0.1,0.2,0.3"}).is_logarithmic());
}

TEST(KeyAxis, PlacesWordsAtEqualDistances) {
  const SweepParameterAxis laws = axis_of(tests::kTwoLaws);
  EXPECT_TRUE(laws.is_categorical());
  EXPECT_EQ(laws.coordinate(std::string("laplace")), 1);
  EXPECT_EQ(tests::tics_of(laws.figure_axis()), "gaussian 0, laplace 1");
  EXPECT_EQ(laws.figure_axis().from, -0.5);
  EXPECT_EQ(laws.figure_axis().to, 1.5);
}

TEST(KeyAxis, OfCellsHasRoundNumbersAtTheirPositions) {
  const SweepParameterAxis restitution = axis_of(tests::kFiveRestitutions);
  EXPECT_EQ(restitution.map_cell_index(0.8), 2u);
  // 0.7 is between the first cell, 0, and the third cell.
  EXPECT_TRUE(contains(tests::tics_of(restitution.figure_axis_of_cells()), "0.7 1, "));
  EXPECT_TRUE(
      contains(tests::tics_of(axis_of(tests::kThreeRates).figure_axis_of_cells()), ", 1 1, "));
  // The cells are in the order of the numbers, also for a decreasing range.
  EXPECT_EQ(axis_of({"system.restitution", "1:0.6:5"}).map_cell_index(0.6), 0u);
}

TEST(KeyAxis, OfAListNamesItsValues) {
  EXPECT_EQ(tests::tics_of(axis_of({"impulse.rate", "0.3,0.7,0.4"}).figure_axis_of_cells()),
            "0.3 0, 0.4 1, 0.7 2");
}

TEST(KeyAxis, OfASobolSequenceHasTheValuesOfItsPoints) {
  const SweepParameterAxis axis(
      tests::made_up_plan({{"system.restitution", "0.6:1"}}, SweepPlanDesign::sobol, 7), 0);
  EXPECT_EQ(axis.values().size(), 7u);
  EXPECT_TRUE(std::ranges::is_sorted(axis.values()));
}

}  // namespace
}  // namespace fpkcheck::sweep
