#include "fd_fpk/operator/resolution.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Resolution, BarsAreTheStricterTheMoreIsExpected) {
  EXPECT_GT(kAutomaticGridBars.least_density, kStationaryBars.least_density);
  EXPECT_GT(kStationaryBars.least_density, kBarsOverTime.least_density);
  EXPECT_LT(kAutomaticGridBars.power, kStationaryBars.power);
  EXPECT_LT(kStationaryBars.power, kBarsOverTime.power);
}

TEST(Resolution, ADensityMayFallToTheBarAndTheBalanceMayMissByItEitherWay) {
  EXPECT_TRUE(kStationaryBars.allow_density(0.99 * kStationaryBars.least_density));
  EXPECT_FALSE(kStationaryBars.allow_density(1.01 * kStationaryBars.least_density));
  for (const double sign : {-1, 1}) {
    EXPECT_TRUE(kStationaryBars.allow_imbalance(sign * 0.99 * kStationaryBars.power));
    EXPECT_FALSE(kStationaryBars.allow_imbalance(sign * 1.01 * kStationaryBars.power));
  }
  EXPECT_FALSE(kStationaryBars.allow_density(kNotANumber));
  EXPECT_FALSE(kStationaryBars.allow_imbalance(kNotANumber));
}

TEST(Resolution, ABoxIsTooSmallWhereEitherWallCarriesDensity) {
  const Grid grid = make_grid(16, 32, 2.5, 3.5);
  EXPECT_EQ(box_objection({}, grid, {0.9 * kMostOnWall, 0.9 * kMostOnWall}), "");
  EXPECT_NE(box_objection({}, grid, {1.1 * kMostOnWall, 0}), "");
  EXPECT_NE(box_objection({}, grid, {kNotANumber, 0}), "");
  EXPECT_EQ(box_objection({}, grid, {0, 0.02}, "at t = 1 "),
            "the box y <= 2.5, |y'| <= 3.5 is too small: at t = 1 the density on its wall is "
            "2.0e-02 of the peak; increase y-max and v-max");
}

TEST(Resolution, ABoxIsNamedByTheSidesThatAreNoWallsInPhysicalCoordinates) {
  const auto said = [](const problem::Frame& frame, Beyond left, Beyond right) {
    const Grid grid = symmetric_grid({0, 1, 2}, {0, 1, 3}, left, right);
    const std::string objection = box_objection(frame, grid, {0, 0, 0.02});
    return objection.substr(0, objection.find(" is too small"));
  };
  using enum Beyond;
  const problem::Frame shifted{.origin = -0.5}, mirrored{.origin = 0.5, .mirrored = true};
  EXPECT_EQ(said({}, vacuum, vacuum), "the box 0 <= y <= 2, |y'| <= 3");
  EXPECT_EQ(said(shifted, boundary, vacuum), "the box y <= 1.5, |y'| <= 3");
  EXPECT_EQ(said(mirrored, boundary, vacuum), "the box y >= -1.5, |y'| <= 3");
  EXPECT_EQ(said(shifted, boundary, boundary), "the box |y'| <= 3");
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
