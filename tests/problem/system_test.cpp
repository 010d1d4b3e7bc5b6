#include "problem/system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/input_error.hpp"

namespace fpkcheck::problem {
namespace {

constexpr SystemCoefficients kGoodCoefficients{
    .damping = 0.1, .stiffness = 1, .cubic = 0.1, .restitution = 0.98};

template <class Change>
void expect_refused(Change change, const std::string& key) {
  SystemCoefficients bad = kGoodCoefficients;
  change(bad);
  try {
    System{bad};
    FAIL() << "accepted a bad " << key;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("system." + key), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(System, RefusesEachCoefficientOutOfItsRangeByName) {
  expect_refused([](auto& c) { c.damping = std::numeric_limits<double>::quiet_NaN(); }, "damping");
  expect_refused([](auto& c) { c.quintic = HUGE_VAL; }, "quintic");
  expect_refused([](auto& c) { c.cubic = 1e31; }, "cubic");
  expect_refused([](auto& c) { c.restitution = 0; }, "restitution");
  expect_refused([](auto& c) { c.restitution = 1.0001; }, "restitution");
}

TEST(System, AcceptsTheEndsOfTheRanges) {
  EXPECT_NO_THROW(System({.damping = 0.1, .stiffness = 1, .cubic = 0, .restitution = 1}));
  EXPECT_NO_THROW(System({.damping = 0.1, .stiffness = 0, .cubic = 1, .restitution = 0.01}));
}

TEST(System, ForceIsLinearPlusCubicAndItsSlopeAndPotentialFollow) {
  const System system(kGoodCoefficients);
  EXPECT_DOUBLE_EQ(system.restoring_force()(2.0), 2.0 + 0.1 * 8.0);
  EXPECT_DOUBLE_EQ(system.tangent_stiffness()(2.0), 1 + 3 * 0.1 * 4.0);
  EXPECT_DOUBLE_EQ(system.potential()(2.0), 2.0 + 0.1 * 16.0 / 4);
  EXPECT_DOUBLE_EQ(system.stiffness(), 1);
  EXPECT_FALSE(system.has_linear_force());
  EXPECT_TRUE(
      System({.damping = 1, .stiffness = 2, .cubic = 0, .restitution = 1}).has_linear_force());
}

}  // namespace
}  // namespace fpkcheck::problem
