#include "fd_fpk/stationary/status_checks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Resolution, LimitsAreStricterForAutomaticGridsThanForResults) {
  EXPECT_GT(kAutomaticGridResolutionLimits.min_density, kStationaryResolutionLimits.min_density);
  EXPECT_GT(kStationaryResolutionLimits.min_density, kTransientResolutionLimits.min_density);
  EXPECT_LT(kAutomaticGridResolutionLimits.power, kStationaryResolutionLimits.power);
  EXPECT_LT(kStationaryResolutionLimits.power, kTransientResolutionLimits.power);
}

TEST(Resolution, AcceptsValuesUpToTheLimitsOfEitherSign) {
  EXPECT_TRUE(kStationaryResolutionLimits.is_density_accepted(
      0.99 * kStationaryResolutionLimits.min_density));
  EXPECT_FALSE(kStationaryResolutionLimits.is_density_accepted(
      1.01 * kStationaryResolutionLimits.min_density));
  for (const double sign : {-1, 1}) {
    EXPECT_TRUE(kStationaryResolutionLimits.is_power_residual_accepted(
        sign * 0.99 * kStationaryResolutionLimits.power));
    EXPECT_FALSE(kStationaryResolutionLimits.is_power_residual_accepted(
        sign * 1.01 * kStationaryResolutionLimits.power));
  }
  EXPECT_FALSE(kStationaryResolutionLimits.is_density_accepted(kNotANumber));
  EXPECT_FALSE(kStationaryResolutionLimits.is_power_residual_accepted(kNotANumber));
}

TEST(Resolution, ABoxIsTooSmallWhereEitherWallCarriesDensity) {
  const PhasePlaneGrid grid = make_grid(16, 32, 2.5, 3.5);
  EXPECT_EQ(
      small_box_failure_reason({}, grid, {0.9 * kMaxBoxEdgeDensity, 0.9 * kMaxBoxEdgeDensity}), "");
  EXPECT_NE(small_box_failure_reason({}, grid, {1.1 * kMaxBoxEdgeDensity, 0}), "");
  EXPECT_NE(small_box_failure_reason({}, grid, {kNotANumber, 0}), "");
  EXPECT_EQ(small_box_failure_reason({}, grid, {0, 0.02}, "at t = 1 "),
            "the box y <= 2.5, |y'| <= 3.5 is too small: at t = 1 the density on its wall is "
            "2.0e-02 of the peak; increase y-max and v-max");
}

TEST(Resolution, AMessageStatesTheFreeSidesInPhysicalCoordinates) {
  const auto said = [](const problem::WallFrame& frame, AxisEndCondition left,
                       AxisEndCondition right) {
    const PhasePlaneGrid grid = symmetric_grid({0, 1, 2}, {0, 1, 3}, left, right);
    const std::string objection = small_box_failure_reason(frame, grid, {0, 0, 0.02});
    return objection.substr(0, objection.find(" is too small"));
  };
  using enum AxisEndCondition;
  const problem::WallFrame shifted{.origin = -0.5}, mirrored{.origin = 0.5, .mirrored = true};
  EXPECT_EQ(said({}, vacuum, vacuum), "the box 0 <= y <= 2, |y'| <= 3");
  EXPECT_EQ(said(shifted, boundary, vacuum), "the box y <= 1.5, |y'| <= 3");
  EXPECT_EQ(said(mirrored, boundary, vacuum), "the box y >= -1.5, |y'| <= 3");
  EXPECT_EQ(said(shifted, boundary, boundary), "the box |y'| <= 3");
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
