#include "problem/features.hpp"

#include <gtest/gtest.h>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

const tests::Parameters kCase1{};

TEST(ProblemFeatures, IdentifyThePapersClass) {
  EXPECT_TRUE(features(tests::make_problem(kCase1)).is_paper_oscillator);
  Problem noisy = tests::make_problem(kCase1);
  noisy.noise.intensity = 0.1;
  EXPECT_FALSE(features(noisy).is_paper_oscillator);
  const auto other = [](const SystemCoefficients& coefficients, const WallParameters& walls = {}) {
    return features(
               tests::with_impulses(System(coefficients, walls), tests::gaussian_impulses(1, 1)))
        .is_paper_oscillator;
  };
  EXPECT_TRUE(other({.damping = 0.1, .cubic = 1, .restitution = 1}));
  EXPECT_TRUE(other({.damping = 0.1, .stiffness = 1}, {.left = 0, .left_restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .stiffness = 1}, {.left = -1, .left_restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .stiffness = -1, .cubic = 1, .restitution = 1}));
  EXPECT_FALSE(other({.damping = 0, .stiffness = 1, .restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .van_der_pol = 1, .stiffness = 1, .restitution = 0.5}));
}

ProblemFeatures with_wall(double constant, double r, double noise) {
  return features({.name = "test",
                   .system = System({.damping = 0.1, .constant = constant, .stiffness = 1},
                                    {.left = 0, .left_restitution = r}),
                   .impulses = tests::gaussian_impulses(1, 1),
                   .noise = {noise}});
}

TEST(ProblemFeatures, RestInContactNeedsPressureLossesAndNoNoise) {
  EXPECT_TRUE(with_wall(0.1, 0.7, 0).rests_in_contact);
  EXPECT_FALSE(with_wall(-0.1, 0.7, 0).rests_in_contact);
  EXPECT_FALSE(with_wall(0, 0.7, 0).rests_in_contact);
  EXPECT_FALSE(with_wall(0.1, 1, 0).rests_in_contact);
  EXPECT_FALSE(with_wall(0.1, 0.7, 0.1).rests_in_contact);
  EXPECT_TRUE(with_wall(-0.1, 0.7, 0).offset_wall);
}

TEST(ProblemFeatures, CollapseNeedsNoiseAndStrongLosses) {
  EXPECT_TRUE(with_wall(0, 0.16, 0.1).collapse);
  EXPECT_FALSE(with_wall(0, 0.17, 0.1).collapse);
  EXPECT_FALSE(with_wall(0, 0.16, 0).collapse);
}

}  // namespace
}  // namespace fpkcheck::problem
