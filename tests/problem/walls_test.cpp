#include "problem/walls.hpp"

#include <gtest/gtest.h>

#include <string>

#include "general_oscillators.hpp"
#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

std::string refusal(const WallParameters& walls, const std::optional<double>& restitution = {}) {
  return tests::refusal([&] { make_walls(walls, restitution); });
}

TEST(Walls, OfSystemRestitutionAreOneAtZero) {
  const Walls walls = make_walls({}, 0.9);
  EXPECT_EQ(walls.left, (Wall{0, 0.9}));
  EXPECT_FALSE(walls.right);
}

TEST(Walls, HaveEachTheirOwnRestitution) {
  const Walls walls = make_walls(
      {.left = -1, .left_restitution = 0.7, .right = 2, .right_restitution = 0.9}, std::nullopt);
  EXPECT_EQ(walls.left, (Wall{-1, 0.7}));
  EXPECT_EQ(walls.right, (Wall{2, 0.9}));
  const Walls none = make_walls({.none = true}, std::nullopt);
  EXPECT_FALSE(none.left || none.right);
}

TEST(Walls, AreRejectedWhenIncompleteOrDuplicate) {
  EXPECT_NE(refusal({}).find("'system.restitution' is missing"), std::string::npos);
  EXPECT_NE(refusal({.none = true}, 0.9).find("system.restitution = 0.9 beside [wall]"),
            std::string::npos);
  EXPECT_NE(refusal({.left = 0}).find("wall.left_restitution is missing"), std::string::npos);
  EXPECT_NE(refusal({.right_restitution = 1}).find("wall.right is missing"), std::string::npos);
  EXPECT_NE(refusal({.left = 0, .left_restitution = 1, .none = true}).find("wall.none"),
            std::string::npos);
  EXPECT_NE(refusal({.left = 1, .left_restitution = 1, .right = 1, .right_restitution = 1})
                .find("wall.left = 1 (must be below wall.right = 1)"),
            std::string::npos);
  EXPECT_NE(refusal({.left = 0, .left_restitution = 1.5}).find("wall.left_restitution = 1.5"),
            std::string::npos);
}

TEST(Walls, GiveTheSpeedBeforeAnImpact) {
  const Walls walls =
      make_walls({.left = 0,
                  .left_restitution = base::NumberOrFormula(std::string("1 - 0.3*min(1,v)")),
                  .right = 1,
                  .right_restitution = 0.8},
                 std::nullopt);
  EXPECT_DOUBLE_EQ(speed_before_impact(*walls.right, 0.4), 0.5);
  const double u = speed_before_impact(*walls.left, 0.4);
  EXPECT_NEAR(u * (1 - 0.3 * u), 0.4, 1e-14);
  EXPECT_EQ(speed_before_impact(*walls.left, 0), 0);
}

// All coefficients of the system are nonzero, so that the test covers the transformation of each
// term.
const SystemCoefficients kAll{.damping = 0.1,
                              .van_der_pol = 0.2,
                              .rayleigh = 0.3,
                              .constant = 0.4,
                              .stiffness = 0.5,
                              .quadratic = 0.6,
                              .cubic = 0.7,
                              .quintic = 0.8};

double g(double y) {
  return 0.4 + 0.5 * y + 0.6 * y * y + 0.7 * y * y * y + 0.8 * y * y * y * y * y;
}

TEST(WallFrame, OfTheLeftWallShiftsForceAndDamping) {
  const System system(
      kAll, {.left = -0.5, .left_restitution = 0.7, .right = 2, .right_restitution = 0.9});
  const Problem seen =
      tests::in_wall_coordinates(tests::with_impulses(system, tests::gaussian_impulses(1, 1, 0.3)));
  EXPECT_EQ(seen.frame, (WallFrame{-0.5, false}));
  EXPECT_EQ(seen.system.left_wall(), (Wall{0, 0.7}));
  EXPECT_EQ(seen.system.right_wall(), (Wall{2.5, 0.9}));
  for (const double x : {0.0, 0.3, 1.7}) {
    const double y = x - 0.5;
    EXPECT_NEAR(seen.system.restoring_force()(x), g(y), 1e-14);
    EXPECT_NEAR(seen.system.damping_polynomial()(x), 0.1 + 0.2 * y * y, 1e-15);
    EXPECT_NEAR(seen.system.potential()(x), system.potential()(y) - system.potential()(-0.5),
                1e-14);
  }
  EXPECT_EQ(seen.impulses.amplitude_law().mean(), 0.3);
}

TEST(WallFrame, OfARightWallAloneIsMirrored) {
  const System system(kAll, {.right = 2, .right_restitution = 0.9});
  const Problem seen =
      tests::in_wall_coordinates(tests::with_impulses(system, tests::gaussian_impulses(1, 1, 0.3)));
  EXPECT_EQ(seen.frame, (WallFrame{2, true}));
  EXPECT_EQ(seen.system.left_wall(), (Wall{0, 0.9}));
  EXPECT_FALSE(seen.system.right_wall());
  for (const double x : {0.0, 0.3, 1.7}) {
    EXPECT_NEAR(seen.system.restoring_force()(x), -g(2 - x), 1e-13);
    EXPECT_NEAR(seen.system.damping_polynomial()(x), 0.1 + 0.2 * (2 - x) * (2 - x), 1e-15);
  }
  EXPECT_EQ(seen.impulses.amplitude_law().mean(), -0.3);
  EXPECT_EQ(seen.frame.physical_y(0.5), 1.5);
  EXPECT_EQ(seen.frame.wall_coordinate(1.5), 0.5);
  EXPECT_EQ(seen.frame.physical_velocity(1), -1);
}

TEST(WallFrame, OfThePapersClassIsTheIdentity) {
  const Problem problem{"test",
                        System({.damping = 0.1, .stiffness = 1, .cubic = 0.1, .restitution = 0.9}),
                        tests::gaussian_impulses(1, 1)};
  EXPECT_TRUE(wall_frame(problem.system).is_identity());
  EXPECT_EQ(tests::in_wall_coordinates(problem).system.restoring_force().coefficients(),
            problem.system.restoring_force().coefficients());
}

TEST(WallFrame, OfAProblemInItsFrameChangesNothing) {
  const System system(kAll, {.right = 2, .right_restitution = 0.9});
  const Problem seen =
      tests::in_wall_coordinates(tests::with_impulses(system, tests::gaussian_impulses(1, 1, 0.3)));
  const Problem again = tests::in_wall_coordinates(seen);
  EXPECT_EQ(again.frame, seen.frame);
  EXPECT_EQ(again.system.left_wall(), seen.system.left_wall());
  EXPECT_EQ(again.system.restoring_force().coefficients(),
            seen.system.restoring_force().coefficients());
  EXPECT_EQ(again.impulses.amplitude_law().mean(), -0.3);
}

TEST(WallFrame, InverseRoundTrips) {
  for (const WallFrame frame : {WallFrame{-0.5, false}, WallFrame{2, true}, WallFrame{}}) {
    const WallFrame back = frame.inverse_frame();
    for (const double x : {0.0, 0.3, 1.7}) {
      EXPECT_NEAR(back.physical_y(frame.physical_y(x)), x, 1e-15);
      EXPECT_NEAR(back.wall_coordinate(x), frame.physical_y(x), 1e-15);
      EXPECT_EQ(back.physical_velocity(frame.physical_velocity(x)), x);
    }
    EXPECT_EQ(back.is_identity(), frame.is_identity());
  }
}

}  // namespace
}  // namespace fpkcheck::problem
