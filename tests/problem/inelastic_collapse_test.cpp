#include "problem/inelastic_collapse.hpp"

#include <gtest/gtest.h>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

TEST(InelasticCollapse, AffectsOnlyWhiteWithoutNoiseUpToTheThreshold) {
  const auto objection = [](double r, Equation equation) {
    return inelastic_collapse_reason(tests::make_problem({.restitution = r}), equation);
  };
  EXPECT_TRUE(objection(0.1631, Equation::white).empty());
  EXPECT_FALSE(objection(0.1630, Equation::white).empty());
  for (const auto equation : {Equation::km4, Equation::km4_pade, Equation::kf}) {
    EXPECT_TRUE(objection(0.1, equation).empty()) << name(equation);
  }
}

TEST(InelasticCollapse, MayBeAtEitherWallAndUnderNoiseOfTheProblem) {
  const System system({.damping = 0.1, .stiffness = 1},
                      {.left = -1, .left_restitution = 0.5, .right = 1, .right_restitution = 0.12});
  Problem p = tests::with_impulses(system, tests::gaussian_impulses(1, 1));
  EXPECT_TRUE(inelastic_collapse_reason(p, Equation::kf).empty());
  EXPECT_NE(inelastic_collapse_reason(p, Equation::white).find("restitution 0.12"),
            std::string::npos);
  p.noise.intensity = 0.1;
  const auto text = inelastic_collapse_reason(p, Equation::kf);
  EXPECT_NE(text.find("restitution 0.12"), std::string::npos) << text;
  // The equation kf contains the noise of the problem, too.
  EXPECT_EQ(text.find("solve kf"), std::string::npos) << text;
}

TEST(InelasticCollapse, StatesCauseAndAction) {
  const auto text =
      inelastic_collapse_reason(tests::make_problem({.restitution = 0.15}), Equation::white);
  EXPECT_NE(text.find("restitution 0.15"), std::string::npos) << text;
  EXPECT_NE(text.find("0.1630"), std::string::npos) << text;
  EXPECT_NE(text.find("solve kf"), std::string::npos) << text;
}

}  // namespace
}  // namespace fpkcheck::problem
