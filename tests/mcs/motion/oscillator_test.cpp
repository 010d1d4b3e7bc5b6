#include "mcs/motion/oscillator.hpp"

#include <gtest/gtest.h>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::mcs {
namespace {

using Kind = SimulatedOscillator::Kind;

Kind kind_of(const problem::SystemCoefficients& coefficients,
             const problem::WallParameters& walls = {}) {
  const auto problem =
      tests::with_impulses(problem::System(coefficients, walls), tests::gaussian_impulses(1, 0.1));
  return make_oscillator(problem, problem::motion_scales(problem)).kind;
}

TEST(Oscillator, OfTheProblemHasItsMechanics) {
  const auto problem = tests::make_problem({.damping = 0.3, .restitution = 0.7});
  const SimulatedOscillator oscillator = make_oscillator(problem, problem::motion_scales(problem));
  EXPECT_EQ(oscillator.damping[0], 0.3);
  EXPECT_TRUE(oscillator.left.exists);
  EXPECT_FALSE(oscillator.right.exists);
  EXPECT_EQ(oscillator.left.restitution, 0.7);
  EXPECT_EQ(oscillator.left.contact_force, 0);
  for (std::size_t n = 0; n < oscillator.force.size(); ++n) {
    EXPECT_EQ(oscillator.force[n], problem.system.restoring_force().coefficient(n));
  }
}

// With the kind duffing_at_wall the energy limits the flights; each condition is necessary.
TEST(Oscillator, HasTheKindOfItsTerms) {
  constexpr double r = 0.8;
  EXPECT_EQ(kind_of({.damping = 0.1, .stiffness = 1, .restitution = r}), Kind::duffing_at_wall);
  EXPECT_EQ(kind_of({.damping = 0.1, .cubic = 2, .restitution = r}), Kind::duffing_at_wall);
  EXPECT_EQ(kind_of({.damping = 0.1, .stiffness = 1, .cubic = 2, .restitution = r}),
            Kind::duffing_at_wall);
  EXPECT_EQ(kind_of({.damping = 0.1, .constant = 0.1, .stiffness = 1, .restitution = r}),
            Kind::linear);
  EXPECT_EQ(kind_of({.damping = 0.1, .stiffness = 1}, {.none = true}), Kind::linear);
  EXPECT_EQ(kind_of({.damping = 0.1, .stiffness = -1, .cubic = 1, .restitution = r}), Kind::cubic);
  EXPECT_EQ(
      kind_of({.damping = 0.1, .stiffness = 1, .quadratic = 0.1, .cubic = 2, .restitution = r}),
      Kind::cubic);
  EXPECT_EQ(kind_of({.damping = 0.1, .van_der_pol = 0.1, .stiffness = 1, .restitution = r}),
            Kind::cubic);
  EXPECT_EQ(kind_of({.damping = 0.1, .stiffness = 1, .quintic = 0.1, .restitution = r}),
            Kind::full);
  EXPECT_EQ(kind_of({.damping = 0.1, .rayleigh = 0.1, .stiffness = 1, .restitution = r}),
            Kind::full);
  problem::Problem noisy = tests::make_problem({});
  EXPECT_TRUE(is_duffing_at_wall(noisy));
  noisy.noise.intensity = 0.1;
  EXPECT_FALSE(is_duffing_at_wall(noisy));
}

}  // namespace
}  // namespace fpkcheck::mcs
