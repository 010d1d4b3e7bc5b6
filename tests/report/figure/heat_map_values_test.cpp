#include "report/figure/heat_map_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fpkcheck::report {
namespace {

// Two cells of y, four of v; the peak is 10.
const transform::GridDensity kDensity{
    {0, 1, 2}, {-2, -1, 0, 1, 2}, {0.001, 10, 4, 0.5, 0, 0.2, 0.3, 0.001}};

TEST(CellIndexWindow, HoldsAllThatExceedsThePart) {
  const auto wide = window_of_cells_above_peak_fraction(kDensity, 0.01);
  EXPECT_EQ(wide.y_end, 2u);
  EXPECT_EQ(wide.v_begin, 1u);
  EXPECT_EQ(wide.v_end, 4u);
  const auto narrow = window_of_cells_above_peak_fraction(kDensity, 0.1);
  EXPECT_EQ(narrow.y_end, 1u);
  EXPECT_EQ(narrow.v_begin, 1u);
  EXPECT_EQ(narrow.v_end, 3u);
}

TEST(CellIndexWindow, RowsAreOfConstantVelocity) {
  EXPECT_EQ(cell_averages_by_velocity_rows(kDensity, {2, 1, 3}),
            (std::vector<double>{10, 0.2, 4, 0.3}));
}

TEST(QuantisedSignedRoots, ComeBackWithTheirSign) {
  const std::vector<double> values{-2, 2, 0, 0.5, -1e-4, 1e-6};
  constexpr int kMany = 4096;
  const auto packed = quantise_signed_roots(values, kMany);
  EXPECT_EQ(packed.largest, 2);
  EXPECT_EQ(packed.roots[0], -kMany);
  EXPECT_EQ(packed.roots[3], kMany / 2);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double q = static_cast<double>(packed.roots[k]) / packed.levels;
    EXPECT_NEAR(std::copysign(q * q, q) * packed.largest, values[k],
                0.2 * std::abs(values[k]) + 1e-12);
  }
}

TEST(QuantisedSignedRoots, OfNothingAreNothing) {
  EXPECT_EQ(quantise_signed_roots(std::vector<double>{0, 0}, 127).roots, (std::vector<int>{0, 0}));
}

TEST(QuantisedSignedRoots, AreTheSumsOfTheirSteps) {
  EXPECT_EQ(successive_differences(std::vector{5, 7, -1}), (std::vector{5, 2, -8}));
  EXPECT_TRUE(successive_differences({}).empty());
}

}  // namespace
}  // namespace fpkcheck::report
