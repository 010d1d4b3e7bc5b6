#include "report/page/cell_window.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

// Two cells of y, four of v; the peak is 10.
const transform::GridDensity kDensity{
    {0, 1, 2}, {-2, -1, 0, 1, 2}, {0.001, 10, 4, 0.5, 0, 0.2, 0.3, 0.001}};

TEST(CellWindow, HoldsAllThatExceedsThePart) {
  const auto wide = cells_above_fraction(kDensity, 0.01);
  EXPECT_EQ(wide.y_end, 2u);
  EXPECT_EQ(wide.v_begin, 1u);
  EXPECT_EQ(wide.v_end, 4u);
  const auto narrow = cells_above_fraction(kDensity, 0.1);
  EXPECT_EQ(narrow.y_end, 1u);
  EXPECT_EQ(narrow.v_begin, 1u);
  EXPECT_EQ(narrow.v_end, 3u);
}

TEST(CellWindow, RowsAreOfConstantVelocity) {
  EXPECT_EQ(rows_of_constant_velocity(kDensity, {2, 1, 3}), (std::vector<double>{10, 0.2, 4, 0.3}));
}

}  // namespace
}  // namespace fpkcheck::report
