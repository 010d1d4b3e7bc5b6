#include "mcs/motion/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/input_error.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using numerics::Polynomial;

Oscillator with_spring(const Polynomial::Coefficients& g) { return {0.1, 1, Polynomial(g)}; }

TEST(Oscillator, OfTheProblemHasItsMechanics) {
  const auto system = tests::make_problem({.damping = 0.3, .restitution = 0.7}).system;
  const Oscillator oscillator(system);
  EXPECT_EQ(oscillator.damping, 0.3);
  EXPECT_EQ(oscillator.restitution, 0.7);
  EXPECT_EQ(oscillator.force.coefficients(), system.restoring_force().coefficients());
  EXPECT_EQ(oscillator.potential.coefficients(), system.potential().coefficients());
}

TEST(Oscillator, DetectsDuffingSprings) {
  EXPECT_TRUE(with_spring({0, 1}).is_duffing);
  EXPECT_TRUE(with_spring({0, 1, 0, 2}).is_duffing);
  EXPECT_TRUE(with_spring({0, 0, 0, 2}).is_duffing);
  EXPECT_FALSE(with_spring({0, 1, 0.1, 2}).is_duffing);
  EXPECT_FALSE(with_spring({0, 1, 0, 2, 0.1}).is_duffing);
  EXPECT_FALSE(with_spring({0, 1, 0, 2, 0, 0.1}).is_duffing);
}

TEST(Oscillator, BoundsItsPotentialFromBelowByTheLastPower) {
  // Without negative terms the bound is the last term.
  EXPECT_EQ(with_spring({0, 1, 0, 2}).potential_bound, 2.0 / 4);
  EXPECT_EQ(with_spring({0, 1, 0.5, 0, 0, 3}).potential_bound, 3.0 / 6);
  // With negative terms the bound is the minimum of the ratio, computed here on a fine grid.
  for (const auto& g : {Polynomial::Coefficients{0, 1, -1, 0.5},
                        {0, 1, -0.6, 0.1},
                        {0, 0.5, 0, -0.3, 0, 0.2},
                        {0, 1, 2, -3, 1, 1},
                        {0, 1e-6, -1e-3, 1}}) {
    const Oscillator oscillator = with_spring(g);
    double least = std::numeric_limits<double>::infinity();
    for (double y = 1e-6; y < 1e6; y *= 1.0003) {
      least = std::min(least, oscillator.potential(y) / std::pow(y, oscillator.degree + 1));
    }
    EXPECT_LE(oscillator.potential_bound, least);
    EXPECT_GE(oscillator.potential_bound, 0.95 * least);
  }
}

TEST(Oscillator, WithoutABoundOfTheMotionIsRefused) {
  EXPECT_THROW(with_spring({0.1, 1}), InputError);         // a force at the wall
  EXPECT_THROW(with_spring({0, 1, 0, -0.1}), InputError);  // repulsive at large y
  EXPECT_THROW(with_spring({0, -1, 0, 1}), InputError);    // repulsive near the wall
  EXPECT_THROW(with_spring({0, 1, -3, 1}), InputError);    // a second, deeper well
  EXPECT_THROW(with_spring({0, 0, 0, -1, 0, 1}), InputError);
}

}  // namespace
}  // namespace fpkcheck::mcs
