#include "problem/walls.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"

namespace fpkcheck::problem {
namespace {

std::string refusal(const WallParameters& walls, const std::optional<double>& restitution = {}) {
  try {
    make_walls(walls, restitution);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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

}  // namespace
}  // namespace fpkcheck::problem
