#include "workflows/sweep/report/figure/key_axis.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

KeyAxis axis_of(const tests::KeyAndValues& axis) { return {tests::made_up_plan({axis}), 0}; }

TEST(KeyAxis, IsLogarithmicForLogarithmicSpacing) {
  const std::string even = axis_of(tests::kFiveRestitutions).commands('x');
  EXPECT_FALSE(contains(even, "logscale")) << even;
  EXPECT_TRUE(contains(
      even, "set xlabel say('system.restitution, {/:Italic r}', 'system.restitution, $r$')"))
      << even;
  const std::string by_decades = axis_of(tests::kThreeRates).commands('y');
  EXPECT_TRUE(contains(by_decades, "set logscale y")) << by_decades;
  EXPECT_TRUE(contains(by_decades, "'0.1' 0.1")) << by_decades;
  EXPECT_TRUE(contains(by_decades, "'10' 10")) << by_decades;
  EXPECT_TRUE(axis_of({"impulse.rate", "0.1,1,10"}).is_logarithmic());
  EXPECT_FALSE(axis_of({"impulse.rate", "0.1,0.2,0.3"}).is_logarithmic());
}

TEST(KeyAxis, PlacesWordsAtEqualDistances) {
  const KeyAxis laws = axis_of(tests::kTwoLaws);
  EXPECT_TRUE(laws.has_words());
  EXPECT_EQ(laws.coordinate(std::string("laplace")), 1);
  const std::string text = laws.commands('x');
  EXPECT_TRUE(contains(text, "'gaussian' 0, 'laplace' 1")) << text;
  EXPECT_TRUE(contains(text, "[-0.5:1.5]")) << text;
}

TEST(KeyAxis, OfCellsHasRoundNumbersAtTheirPositions) {
  const KeyAxis restitution = axis_of(tests::kFiveRestitutions);
  EXPECT_EQ(restitution.cell_index(0.8), 2u);
  // 0.7 is between the first cell, 0, and the third cell.
  EXPECT_TRUE(contains(restitution.cell_axis_commands('x'), "'0.7' 1,"));
  EXPECT_TRUE(contains(axis_of(tests::kThreeRates).cell_axis_commands('y'), "'1' 1,"));
  // The cells are in the order of the numbers, also for a decreasing range.
  EXPECT_EQ(axis_of({"system.restitution", "1:0.6:5"}).cell_index(0.6), 0u);
}

TEST(KeyAxis, OfAListNamesItsValues) {
  const std::string text = axis_of({"impulse.rate", "0.3,0.7,0.4"}).cell_axis_commands('x');
  EXPECT_TRUE(contains(text, "'0.3' 0, '0.4' 1, '0.7' 2")) << text;
}

TEST(KeyAxis, OfASobolSequenceHasTheValuesOfItsPoints) {
  const KeyAxis axis(tests::made_up_plan({{"system.restitution", "0.6:1"}}, PlanDesign::sobol, 7),
                     0);
  EXPECT_EQ(axis.values().size(), 7u);
  EXPECT_TRUE(std::ranges::is_sorted(axis.values()));
}

}  // namespace
}  // namespace fpkcheck::sweep
