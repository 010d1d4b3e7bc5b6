#include <gtest/gtest.h>

#include <sstream>

#include "problem/case_file.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/problem_features.hpp"
#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

Problem general_case(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::istringstream ini(text);
  return read_case(ini, "a", "a.ini", overrides, CaseNamingRule::with_overrides);
}

std::string refusal_of(const std::string& text) {
  return tests::refusal([&] { general_case(text); });
}

const std::string kWells = "[system]\ndamping = 0.1\nstiffness = -1\ncubic = 1\n";
const std::string kNoWall = "[wall]\nnone = true\n";
const std::string kNoise = "[noise]\nintensity = 0.2\n";
const std::string kImpulses = "[impulse]\nrate = 4\nlaw = gaussian\nintensity = 0.5\n";

TEST(GeneralCaseFile, ReadsEveryKey) {
  const Problem p = general_case(
      "[system]\ndamping = -1\nvan_der_pol = 2\nrayleigh = 3\nconstant = 4\nstiffness = 5\n"
      "quadratic = 6\ncubic = 7\nquintic = 8\n[wall]\nleft = -2\nleft_restitution = 0.7\n"
      "right = 3\nright_restitution = 0.8\n" +
      kImpulses + kNoise);
  EXPECT_EQ(p.system.damping(), -1);
  EXPECT_EQ(p.system.damping_polynomial().coefficient(2), 2);
  EXPECT_EQ(p.system.rayleigh_coefficient(), 3);
  const numerics::Polynomial::Coefficients force{4, 5, 6, 7, 0, 8};
  EXPECT_EQ(p.system.restoring_force().coefficients(), force);
  EXPECT_EQ(p.system.left_wall(), (Wall{-2, 0.7}));
  EXPECT_EQ(p.system.right_wall(), (Wall{3, 0.8}));
  EXPECT_EQ(p.noise.intensity, 0.2);
  EXPECT_NEAR(total_excitation_intensity(p), 0.7, 1e-15);
  EXPECT_EQ(non_default_parameters_text(p),
            "c = -1, c_yy = 2, c_vv = 3, g0 = 4, k = 5, k2 = 6, mu = 7, k5 = 8, a = -2, r_a = 0.7, "
            "b = 3, r_b = 0.8; gaussian impulses, lambda = 4, lambda E[Y^2] = 0.5, 2D = 0.2");
}

TEST(GeneralCaseFile, ExcitationMayBeImpulsesOrNoiseOrBoth) {
  EXPECT_FALSE(general_case(kWells + kNoWall + kNoise).impulses.is_acting());
  EXPECT_FALSE(general_case(kWells + kNoWall + kImpulses).noise.is_acting());
  EXPECT_NE(refusal_of(kWells + kNoWall).find("nothing excites the oscillator"), std::string::npos);
  EXPECT_NE(refusal_of(kWells + kNoWall + "[impulse]\nrate = 1\n").find("'impulse.law' is missing"),
            std::string::npos);
}

TEST(GeneralCaseFile, SectionsRoundTrip) {
  for (const std::string& text :
       {kWells + kNoWall + kNoise, kWells + kNoWall + kImpulses,
        kWells + "[wall]\nright = 3\nright_restitution = 0.8\n" + kNoise}) {
    const Problem p = general_case(text), again = problem_from_sections("a", case_file_sections(p));
    EXPECT_EQ(non_default_parameters_text(again), non_default_parameters_text(p));
    EXPECT_EQ(again.system.wall_parameters(), p.system.wall_parameters());
    EXPECT_EQ(total_excitation_intensity(again), total_excitation_intensity(p));
  }
}

TEST(GeneralCaseFile, OldFilesKeepTheirFields) {
  std::istringstream ini("[system]\ndamping = 0.1\nstiffness = 1\ncubic = 0\nrestitution = 1\n" +
                         kImpulses);
  const Problem p = read_case(ini, "a", "a.ini");
  const auto all = case_file_sections(p);
  ASSERT_EQ(all.size(), 2u);
  std::vector<std::string> names;
  for (const auto& value : all[0].values) names.push_back(value.name);
  EXPECT_EQ(names, (std::vector<std::string>{"damping", "stiffness", "cubic", "restitution"}));
}

TEST(GeneralCaseFile, IsNamedByWhatChanges) {
  EXPECT_EQ(
      general_case(kWells + kNoWall + kNoise, {"system.quintic=0.5", "noise.intensity=0.3"}).name,
      "a, k5 = 0.5, 2D = 0.3");
  EXPECT_EQ(general_case(kWells + "[wall]\nright = 3\nright_restitution = 0.8\n" + kNoise,
                         {"wall.right=auto", "wall.right_restitution=auto", "wall.none=true"})
                .name,
            "a, no wall");
}

const std::string kFormula =
    "[system]\nforce = c*v*(1 - y^2) + 0.2*v^3 - y + (y^3)/2 + 0.3\n[parameters]\nc = 0.1\n";

TEST(GeneralCaseFile, FormulaHasTheCoefficientsOfItsPolynomial) {
  const Problem p = general_case(kFormula + kNoWall + kNoise);
  const Problem same = general_case(
      "[system]\ndamping = 0.1\nvan_der_pol = -0.1\nrayleigh = 0.2\nconstant = 0.3\n"
      "stiffness = -1\ncubic = 0.5\n" +
      kNoWall + kNoise);
  EXPECT_EQ(p.system.restoring_force().coefficients(),
            same.system.restoring_force().coefficients());
  EXPECT_EQ(p.system.damping_polynomial().coefficients(),
            same.system.damping_polynomial().coefficients());
  EXPECT_EQ(p.system.rayleigh_coefficient(), same.system.rayleigh_coefficient());
  EXPECT_EQ(p.system.coefficients().van_der_pol, -0.1);
}

TEST(GeneralCaseFile, SectionsKeepFormulaAndConstants) {
  const Problem p = general_case(kFormula + kNoWall + kNoise);
  const auto all = case_file_sections(p);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].values.size(), 1u);
  EXPECT_EQ(all[1].name, "parameters");
  const Problem again = problem_from_sections("a", all);
  EXPECT_EQ(non_default_parameters_text(again), non_default_parameters_text(p));
  EXPECT_EQ(again.system.coefficients().damping, 0.1);
}

TEST(GeneralCaseFile, OverridesChangeConstantsAndReplaceCoefficients) {
  const Problem constant = general_case(kFormula + kNoWall + kNoise, {"parameters.c=0.4"});
  EXPECT_EQ(constant.system.damping(), 0.4);
  EXPECT_EQ(constant.name, "a, c = 0.4");
  const Problem formula = general_case(kWells + kNoWall + kNoise, {"system.force=0.3*v + 2*y"});
  EXPECT_EQ(formula.system.damping(), 0.3);
  EXPECT_EQ(formula.system.stiffness(), 2);
  EXPECT_EQ(formula.system.coefficients().cubic, 0);
}

TEST(GeneralCaseFile, RefusesFormulasThatContradictOrExceedTheFamily) {
  const auto refused = [](const std::string& text, const std::string& where) {
    EXPECT_EQ(refusal_of(text + kNoWall + kNoise).find(where), 0u)
        << refusal_of(text + kNoWall + kNoise);
  };
  refused("[system]\nforce = v + y\ndamping = 1\n", "case a.ini:3");
  refused("[system]\nforce = v - tanh(y)\n", "case a.ini");  // does not confine
  refused("[system]\nforce = v + y + z\n", "case a.ini:2: system.force column 9");
  refused("[system]\nforce = v + y\n[parameters]\ny = 1\n", "case a.ini:4");
  refused("[system]\nforce = v + y\n[parameters]\nm = one\n", "case a.ini:4");
  refused("[system]\nforce = v + y*1e300\n", "case a.ini");
}

// Each message has the form "problem: cause; action" in one line.
TEST(GeneralCaseFile, StatesProblemCauseAndActionOfEachFormula) {
  const auto message = [](const std::string& force, const std::string& more = kNoWall,
                          const std::string& noise = kNoise) {
    return refusal_of("[system]\nforce = " + force + "\n" + more + noise);
  };
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  };
  const std::string at = "case a.ini:2: system.force ";
  expect(message("2y + v"), at + "column 2: expected an operator after the number, as in 2*y");
  expect(message("y^^2 + v"), at + "column 3: expected a number, a name or '('; found '^'");
  expect(message("v**2 + y"), "found '*'; write y^2 for a power");
  expect(message("v + sin y"), at + "column 5: the function sin lacks its argument; write sin(..)");
  expect(message("y' + y"), "write v for the velocity y'");
  expect(message("|v| + y"), "write abs(v) for |v|");
  expect(message("v + y = 0"), "write only the force f");
  expect(message("(v + y"), at + "column 7: expected ')'");
  expect(message("v + y/(2 - 2)"), "division by zero");
  expect(message("v + 1e300*y"), at + "has the coefficient 1e+300 of y^1 v^0");
  expect(message("c*v + y", "[parameter]\nc = 1\n[wall]\nnone = true\n"),
         "write parameters.NAME for a named constant");
  // Potentials that are undefined or do not confine
  expect(message("sqrt(y) + v"), "system.force is undefined at y = -");
  expect(message("-y + v"),
         "on the left; choose a system.force that is negative "
         "where y is large and negative");
  expect(message("v - 1 - exp(-y)"), "on the right; choose a system.force that is positive");
  expect(message("-sin(y) + v"), "does not confine the mass");
  expect(message("sin(y) + v"), "does not confine the mass");
  expect(message("y - v"), "add damping to system.force, such as 0.1*v");
  // Noise and impacts
  expect(message("y + v", "[wall]\nnone = true\n", "[noise]\nintensity = 0.1\nfactor = 1 + v^2\n"),
         "noise.interpretation is missing: the factor depends on v");
  expect(message("y + v", "[wall]\nnone = true\n", "[noise]\nintensity = 0.1\nfactor = y\n"),
         "noise.factor = -");
  const std::string wall = "[wall]\nleft = 0\nleft_restitution = ";
  expect(message("y + v", wall + "1 + v\n"), "case a.ini:5: wall.left_restitution = 1.0");
  expect(
      message("y + v", wall + "1/(1 + v)^2\n"),
      "case a.ini:5: wall.left_restitution gives a speed v r(v) after the impact that decreases");
  expect(message("y + v", "restitution = 1 - 0.1*v\n"), "give a formula as wall.left_restitution");
}

TEST(GeneralCaseFile, RefusesOverridesOfConstantsThatNoFormulaUses) {
  const std::string text =
      "[system]\nforce = c*v + y\n[parameters]\nc = 1\nk = 2\n" + kNoWall + kNoise;
  EXPECT_EQ(general_case(text, {"parameters.c=2"}).system.damping(), 2);
  EXPECT_EQ(general_case(text, {"parameters.k=3"}).system.damping(), 1);  // the file has k
  EXPECT_NE(tests::refusal([&] {
              general_case(text, {"parameters.cc=2"});
            }).find("--set parameters.cc: no formula of the case uses cc"),
            std::string::npos);
  const Problem p = general_case(text, {"system.force=c*v + m*y", "parameters.m=3"});
  EXPECT_EQ(p.system.stiffness(), 3);
  EXPECT_EQ(p.name, "a, f = c*v + m*y, m = 3");
}

// A force whose slopes oscillate confines the mass if its mean does.
TEST(GeneralCaseFile, AcceptsForcesThatConfineOnAverage) {
  for (const char* force : {"v + y + 2*sin(y)", "v + tanh(y)", "v + y/(1 + y^2)^0.25",
                            "v + sign(y)*(0.5 + sin(y)^2)", "v + sinh(y)", "v + y^5*abs(y)"}) {
    EXPECT_EQ(refusal_of(std::string("[system]\nforce = ") + force + "\n" + kNoWall + kNoise),
              "accepted")
        << force;
  }
}

TEST(ExampleSystems, HaveExpectedFeatures) {
  ASSERT_GE(example_oscillator_cases().size(), 12u);
  for (const auto& named : example_oscillator_cases()) {
    const Problem p = load_case(named.name);
    EXPECT_EQ(p.name, named.name);
    EXPECT_FALSE(has_equivalent_linearisation(p)) << p.name;
  }
  EXPECT_TRUE(problem_features(load_case("preload")).rests_in_contact);
  EXPECT_TRUE(problem_features(load_case("ball")).rests_in_contact);
  EXPECT_EQ(problem_features(load_case("stops")).wells, 2);
  EXPECT_TRUE(problem_features(load_case("stops")).rests_in_contact);
  EXPECT_EQ(problem_features(load_case("bistable")).wells, 2);
  EXPECT_TRUE(problem_features(load_case("box")).two_walls);
  EXPECT_TRUE(problem_features(load_case("ring")).negative_damping);
  EXPECT_TRUE(load_case("coulomb").system.has_force_jumps());
  EXPECT_EQ(load_case("bilinear").system.kinks_in_y(-3, 3).size(), 1u);
  EXPECT_EQ(load_case("hertz").system.kinks_in_y(-3, 3).size(), 1u);
  EXPECT_TRUE(load_case("rayleigh").system.has_polynomial_force());
  EXPECT_TRUE(load_case("caughey_ma").noise_factor->depends_on_v());
  EXPECT_EQ(problem_features(load_case("multiplicative_duffing")).wells, 2);
  EXPECT_FALSE(load_case("viscoelastic_impact").system.has_constant_restitution());
}

}  // namespace
}  // namespace fpkcheck::problem
