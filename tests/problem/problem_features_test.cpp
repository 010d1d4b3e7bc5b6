#include "problem/problem_features.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/case_file.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {
namespace {

const tests::Parameters kCase1{};

TEST(EquivalentLinearisation, HoldsForThePapersOscillator) {
  EXPECT_TRUE(has_equivalent_linearisation(tests::make_problem(kCase1)));
  Problem noisy = tests::make_problem(kCase1);
  noisy.noise.intensity = 0.1;
  EXPECT_FALSE(has_equivalent_linearisation(noisy));
  const auto other = [](const SystemCoefficients& coefficients, const WallParameters& walls = {}) {
    return has_equivalent_linearisation(
        tests::with_impulses(System(coefficients, walls), tests::gaussian_impulses(1, 1)));
  };
  EXPECT_TRUE(other({.damping = 0.1, .cubic = 1, .restitution = 1}));
  EXPECT_TRUE(other({.damping = 0.1, .stiffness = 1}, {.left = 0, .left_restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .stiffness = 1}, {.left = -1, .left_restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .stiffness = -1, .cubic = 1, .restitution = 1}));
  EXPECT_FALSE(other({.damping = 0, .stiffness = 1, .restitution = 0.5}));
  EXPECT_FALSE(other({.damping = 0.1, .van_der_pol = 1, .stiffness = 1, .restitution = 0.5}));
}

ProblemFeatures with_wall(double constant, double r, double noise) {
  return problem_features({.name = "test",
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
}

TEST(ProblemFeatures, CollapseNeedsNoiseAndStrongLosses) {
  EXPECT_TRUE(with_wall(0, 0.16, 0.1).collapse);
  EXPECT_FALSE(with_wall(0, 0.17, 0.1).collapse);
  EXPECT_FALSE(with_wall(0, 0.16, 0).collapse);
}

TEST(InelasticCollapse, AffectsOnlyWhiteWithoutNoiseUpToTheThreshold) {
  const auto objection = [](double r, DensityEquation equation) {
    return inelastic_collapse_reason(tests::make_problem({.restitution = r}), equation);
  };
  EXPECT_TRUE(objection(0.1631, DensityEquation::white).empty());
  EXPECT_FALSE(objection(0.1630, DensityEquation::white).empty());
  for (const auto equation :
       {DensityEquation::km4, DensityEquation::km4_pade, DensityEquation::kf}) {
    EXPECT_TRUE(objection(0.1, equation).empty()) << name(equation);
  }
}

TEST(InelasticCollapse, MayBeAtEitherWallAndUnderNoiseOfTheProblem) {
  const System system({.damping = 0.1, .stiffness = 1},
                      {.left = -1, .left_restitution = 0.5, .right = 1, .right_restitution = 0.12});
  Problem p = tests::with_impulses(system, tests::gaussian_impulses(1, 1));
  EXPECT_TRUE(inelastic_collapse_reason(p, DensityEquation::kf).empty());
  EXPECT_NE(inelastic_collapse_reason(p, DensityEquation::white).find("restitution 0.12"),
            std::string::npos);
  p.noise.intensity = 0.1;
  const auto text = inelastic_collapse_reason(p, DensityEquation::kf);
  EXPECT_NE(text.find("restitution 0.12"), std::string::npos) << text;
  // The equation kf contains the noise of the problem, too.
  EXPECT_EQ(text.find("solve kf"), std::string::npos) << text;
}

TEST(InelasticCollapse, StatesCauseAndAction) {
  const auto text =
      inelastic_collapse_reason(tests::make_problem({.restitution = 0.15}), DensityEquation::white);
  EXPECT_NE(text.find("restitution 0.15"), std::string::npos) << text;
  EXPECT_NE(text.find("0.1630"), std::string::npos) << text;
  EXPECT_NE(text.find("solve kf"), std::string::npos) << text;
}

TEST(UnsupportedFeature, IsRecognisedInKeysAndCommands) {
  for (const auto& [subject, words] : unsupported_features()) {
    ASSERT_FALSE(words.empty()) << subject;
    for (const std::string_view each : words) {
      const std::string word(each);
      for (const std::string& name :
           {word, "system." + word, word + ".amplitude", "system.dry_" + word, "first-" + word}) {
        EXPECT_NE(unsupported_feature_message(name).find(subject), std::string::npos) << name;
      }
    }
  }
  EXPECT_EQ(unsupported_feature_message("system.colour"), "");
  EXPECT_EQ(unsupported_feature_message("solve"), "");
}

// No key of the program is reported as unsupported.
TEST(UnsupportedFeature, MatchesNoKeyOfTheProgram) {
  for (const base::OptionsDescriptionBase* section : case_section_descriptions()) {
    for (const auto& parameter : section->parameters()) {
      EXPECT_EQ(unsupported_feature_message(section->prefix() + parameter.name), "")
          << parameter.name;
    }
  }
}

TEST(UnsupportedFeature, IsListedInTheReadme) {
  std::ifstream in(FPKCHECK_README);
  const std::string readme(std::istreambuf_iterator<char>(in), {});
  const auto begin = readme.find("## Unsupported problems");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = readme.substr(begin, readme.find("\n## ", begin + 1) - begin);
  for (const auto& [subject, words] : unsupported_features()) {
    EXPECT_NE(section.find(subject), std::string::npos) << subject;
  }
}

}  // namespace
}  // namespace fpkcheck::problem
