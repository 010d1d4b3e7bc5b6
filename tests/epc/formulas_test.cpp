// Closures of oscillators whose force, noise factor or restitution coefficient is a formula.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "closures.hpp"
#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "epc/solve.hpp"
#include "general_oscillators.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::epc {
namespace {

using problem::Problem;
using transform::Moments;
using transform::Status;

Problem read_problem(const std::string& text) {
  std::istringstream ini(text);
  return tests::in_wall_coordinates(
      problem::read_case(ini, "test", "test.ini", {}, problem::CaseNamingRule::with_overrides));
}

transform::Solution solution_of(const std::string& text, Formulation formulation, int order) {
  return solve_closure(read_problem(text), tests::closure_options(formulation, order)).solution;
}

const std::string kImpulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.3\nmean = 0.1\n";
const std::string kNoise = "[noise]\nintensity = 0.2\n";
const std::string kNoWall = "[wall]\nnone = true\n";

std::string system(const std::string& force) { return "[system]\nforce = " + force + "\n"; }

void expect_equal_moments(const Moments& a, const Moments& b, double tolerance) {
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // the moments of the problems are about 1, or 0 by symmetry
    EXPECT_NEAR(a.*moment, b.*moment, tolerance * (1 + std::abs(a.*size))) << name;
  }
}

// The term 0*abs(y) hides a polynomial from System, and 0*v a number from Wall.

TEST(ClosureOfFormula, IsThatOfTheHiddenPolynomialWithoutAWall) {
  int solved = 0;
  for (const std::string force :
       {"0.2*v + y + 0.1*y^3", "0.1*v + 0.1*v*y^2 + 0.05*v^3 + 0.1 + y + 0.2*y^2 + 0.3*y^3"}) {
    for (const std::string& excitation : {kNoise, kImpulses}) {
      for (const auto formulation : {Formulation::gaussian, Formulation::moment}) {
        const auto solve_force = [&](const std::string& f) {
          return solution_of(system(f) + kNoWall + excitation, formulation, 4);
        };
        const auto polynomial = solve_force(force), formula = solve_force(force + " + 0*abs(y)");
        // The branches of the two problems start differently, and either branch may lack a root.
        if (!polynomial.has_status_ok()) continue;
        ++solved;
        ASSERT_EQ(formula.status, Status::ok) << formula.reason;
        expect_equal_moments(polynomial.moments, formula.moments, 1e-8);
        EXPECT_NEAR(polynomial.energy_residual, formula.energy_residual, 1e-6);
      }
    }
  }
  EXPECT_GE(solved, 6);
}

TEST(ClosureOfFormula, IsThatOfTheHiddenPolynomialBetweenWalls) {
  const auto text = [](const std::string& force, const std::string& r) {
    return system(force) + "[wall]\nleft = -0.5\nleft_restitution = " + r +
           "\nright = 1\nright_restitution = " + r + "\n" + kImpulses + kNoise;
  };
  const auto polynomial = solution_of(text("0.2*v + y + 0.1*y^3", "0.9"), Formulation::moment, 6);
  const auto formula =
      solution_of(text("0.2*v + y + 0.1*y^3 + 0*abs(y-0.3)", "0.9 + 0*v"), Formulation::moment, 6);
  ASSERT_TRUE(polynomial.density) << polynomial.reason;
  ASSERT_TRUE(formula.density) << formula.reason;
  EXPECT_EQ(polynomial.status, formula.status) << formula.reason;
  expect_equal_moments(polynomial.moments, formula.moments, 1e-7);
  EXPECT_NEAR(polynomial.energy_residual, formula.energy_residual, 1e-6);
}

// For a wall on the right the wall coordinates are mirrored.
TEST(ClosureOfFormula, IsThatOfTheHiddenPolynomialAtAMirroredWall) {
  for (const auto formulation : {Formulation::gaussian, Formulation::moment}) {
    const auto solve_with = [&](const std::string& hidden) {
      return solution_of(system("0.2*v + y + 0.1*y^3 + 0.05*y^2" + hidden) +
                             "[wall]\nright = 0.05\nright_restitution = 0.98" +
                             (hidden.empty() ? "" : " + 0*v") + "\n" + kImpulses + kNoise,
                         formulation, 4);
    };
    const auto polynomial = solve_with(""), formula = solve_with(" + 0*abs(y)");
    ASSERT_TRUE(polynomial.density) << polynomial.reason;
    ASSERT_TRUE(formula.density) << formula.reason;
    expect_equal_moments(polynomial.moments, formula.moments, 1e-8);
  }
}

// p = exp(-(v^2/2 + y^2/2 + y^4/40)): D (v G - G_v) is the damping force for noise of any factor G.
const Moments kExponentialLaw = [] {
  // moments of exp(-y^2/2 - y^4/40) by Simpson's rule
  double mass = 0, second = 0, fourth = 0;
  constexpr int kSteps = 4000;
  for (int k = 0; k <= kSteps; ++k) {
    const double y = -8 + 16.0 * k / kSteps;
    const double weight = (k % 2 == 0 ? 2 : 4) * std::exp(-y * y / 2 - std::pow(y, 4) / 40);
    mass += weight;
    second += weight * y * y;
    fourth += weight * std::pow(y, 4);
  }
  return Moments{.y1 = 0, .y2 = second / mass, .y4 = fourth / mass, .v1 = 0, .v2 = 1, .v4 = 3};
}();

void expect_exponential_law(const std::string& text, Formulation formulation, double tolerance) {
  const auto solution = solution_of(text, formulation, 4);
  ASSERT_EQ(solution.status, Status::ok) << text << solution.reason;
  expect_equal_moments(kExponentialLaw, solution.moments, tolerance);
  EXPECT_NEAR(solution.energy_residual, 0, 1e-6) << text;
}

TEST(ClosureOfFormula, IsExactForNoiseWithAFactorOfTheState) {
  // G = 1 + tanh(v)^2/2 + y^2/(1 + y^2)
  const std::string text =
      system("0.1*(v*(1 + 0.5*tanh(v)^2 + y^2/(1+y^2)) - tanh(v)*(1 - tanh(v)^2)) + y + 0.1*y^3") +
      kNoWall + kNoise + "factor = sqrt(1 + 0.5*tanh(v)^2 + y^2/(1+y^2))\ninterpretation = ito\n";
  expect_exponential_law(text, Formulation::gaussian, 1e-8);
  expect_exponential_law(text, Formulation::moment, 1e-6);
}

// With an elastic wall at y = 0 the law is the half y >= 0 of the symmetric law.
TEST(ClosureOfFormula, IsExactForNoiseWithAFactorAtAnElasticWall) {
  const std::string text =
      system("0.1*(v*(1 + 0.5*tanh(v)^2) - tanh(v)*(1 - tanh(v)^2)) + y + 0.1*y^3") +
      "[wall]\nleft = 0\nleft_restitution = 1 + 0*v\n" + kNoise +
      "factor = sqrt(1 + 0.5*tanh(v)^2)\ninterpretation = ito\n";
  for (const auto formulation : {Formulation::gaussian, Formulation::moment}) {
    const auto solution = solution_of(text, formulation, 4);
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_NEAR(solution.moments.y2, kExponentialLaw.y2, 1e-6);
    EXPECT_NEAR(solution.moments.v4, 3, 1e-6);
    EXPECT_NEAR(solution.energy_residual, 0, 1e-6);
  }
}

// In Stratonovich's sense the equation contains the additional drift D G_v / 2.
TEST(ClosureOfFormula, IsExactForNoiseInStratonovichSense) {
  const std::string text =
      system("0.1*(v*(1 + 0.5*tanh(v)^2) - 0.5*tanh(v)*(1 - tanh(v)^2)) + y + 0.1*y^3") + kNoWall +
      kNoise + "factor = sqrt(1 + 0.5*tanh(v)^2)\ninterpretation = stratonovich\n";
  expect_exponential_law(text, Formulation::gaussian, 1e-8);
  expect_exponential_law(text, Formulation::moment, 1e-6);
}

// A factor of y with kinks: p = C exp(-c H/D) for f = c v g^2 + V', here c = D.
TEST(ClosureOfFormula, IsExactForAFactorWithKinks) {
  const std::string text = system("0.1*v*(1 + abs(y - 0.3))^2 + y + 0.1*y^3") + kNoWall + kNoise +
                           "factor = 1 + abs(y - 0.3)\n";
  expect_exponential_law(text, Formulation::gaussian, 1e-8);
  expect_exponential_law(text, Formulation::moment, 1e-6);
}

// Gaussian impulses of rate 1 and the damping for which p = C exp(-H) with any spring (Vasta 1995).
TEST(ClosureOfFormula, IsExactForADampingThatMakesTheVelocityGaussianUnderImpulses) {
  const std::string force =
      "sqrt(pi/2)*exp(v^2/2)*(erfc(v/sqrt(3)) - erfc(v/sqrt(2))) + y + 0.1*y^3";
  const std::string impulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.5\n";
  expect_exponential_law(system(force) + kNoWall + impulses, Formulation::moment, 1e-6);
  const auto bounded = solution_of(
      system(force) +
          "[wall]\nleft = -8\nleft_restitution = 1\nright = 8\nright_restitution = 1\n" + impulses,
      Formulation::moment, 4);
  ASSERT_EQ(bounded.status, Status::ok) << bounded.reason;
  EXPECT_NEAR(bounded.moments.y2, kExponentialLaw.y2, 1e-6);
}

// Damping 0.1 + 0.1 H and G = 1 + H/2 under noise with D = 0.1: p = C (1 + H/2) exp(-2H), which is
// no exponential polynomial. E[y^2] = E[v^2] = 0.6, E[y^4] = 1.05.
TEST(ClosureOfFormula, ConvergesToTheLawOfTheEnergy) {
  const std::string text = system("0.1*v + 0.05*v*(y^2+v^2) + y") + kNoWall + kNoise +
                           "factor = sqrt(1 + 0.25*(y^2+v^2))\ninterpretation = ito\n";
  for (const auto formulation : {Formulation::gaussian, Formulation::moment}) {
    double before = 1;
    for (const int order : {4, 6}) {
      const auto solution = solution_of(text, formulation, order);
      ASSERT_TRUE(solution.density) << solution.reason;
      const double error = std::abs(solution.moments.y4 / 1.05 - 1);
      EXPECT_LT(error, 5e-3) << order;
      EXPECT_LT(error, before) << order;
      before = error;
    }
  }
}

// Bilinear spring under white noise: p = C exp(-c H/D) with c/D = 2. V has a kink in its second
// derivative, which no polynomial has.
TEST(ClosureOfFormula, ConvergesToTheLawOfABilinearSpring) {
  const std::string text = system("0.2*v + y + 4*max(y-0.5,0)") + kNoWall + kNoise;
  double mass = 0, second = 0;
  constexpr int kSteps = 20000;
  for (int k = 0; k <= kSteps; ++k) {
    const double y = -8 + 16.0 * k / kSteps, beyond = std::max(y - 0.5, 0.0);
    const double weight = std::exp(-y * y - 4 * beyond * beyond);
    mass += weight;
    second += weight * y * y;
  }
  const auto error = [&](Formulation formulation, int order) {
    const auto solution = solution_of(text, formulation, order);
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_NEAR(solution.moments.v2, 0.5, 1e-6);
    return std::abs(solution.moments.y2 / (second / mass) - 1);
  };
  EXPECT_LT(error(Formulation::gaussian, 4), 0.01);
  const double fourth = error(Formulation::moment, 4);
  EXPECT_LT(fourth, 2e-3);
  EXPECT_LT(error(Formulation::moment, 8), fourth / 2);
}

// Under impulses, the moments of `fpkcheck fd` (kf, with stated errors below 1e-4): a quadratic
// damping without a wall, and a wall whose restitution coefficient depends on the impact speed.
TEST(ClosureOfFormula, IsNearFiniteVolumesUnderImpulses) {
  const auto impulses = [](const std::string& intensity) {
    return "[impulse]\nrate = 1\nlaw = gaussian\nintensity = " + intensity + "\n";
  };
  const std::string quadratic = system("0.2*v*abs(v) + y + 0.1*y^3") + kNoWall + impulses("0.5");
  const std::string impact = system("0.1*v + y") +
                             "[wall]\nleft = 0\nleft_restitution = 1 - 0.3*min(1,abs(v))^0.2\n" +
                             impulses("0.2");
  const struct {
    std::string text;
    double y2, v2;
  } cases[] = {{quadratic, 0.7261376, 0.8636704}, {impact, 0.3253038, 0.3253038}};
  for (const auto& [text, y2, v2] : cases) {
    double before = 1;
    for (const int order : {4, 8}) {
      const auto solution = solution_of(text, Formulation::moment, order);
      ASSERT_EQ(solution.status, Status::ok) << solution.reason;
      const double error = std::abs(solution.moments.y2 / y2 - 1);
      EXPECT_LT(error, order == 4 ? 0.03 : 0.006) << text;
      EXPECT_LT(error, before) << text;
      EXPECT_NEAR(solution.moments.v2 / v2, 1, order == 4 ? 0.03 : 0.006) << text;
      before = error;
    }
  }
  const auto gaussian = solution_of(quadratic, Formulation::gaussian, 4);
  ASSERT_EQ(gaussian.status, Status::ok) << gaussian.reason;
  EXPECT_NEAR(gaussian.moments.y2 / 0.7261376, 1, 0.03);
}

// Panels cannot end along the line v = -y, on which the force jumps.
TEST(ClosureOfFormula, IsNotConvergedIfTheQuadratureIsNot) {
  const std::string text = system("0.2*v + y + 0.5*sign(v + y)") + kNoWall + kNoise;
  const auto gaussian = solution_of(text, Formulation::gaussian, 4);
  EXPECT_EQ(gaussian.status, Status::not_converged);
  EXPECT_NE(gaussian.reason.find("narrower panels change the weighted moments"), std::string::npos)
      << gaussian.reason;
  const auto moment = solution_of(text, Formulation::moment, 4);
  EXPECT_EQ(moment.status, Status::not_converged);
  EXPECT_NE(moment.reason.find("quadrature points"), std::string::npos) << moment.reason;
}

TEST(ClosureOfFormula, IsNotOfferedWhereItsLawIsSingular) {
  const auto reason = [](const std::string& text, Formulation formulation) {
    return unsupported_reason(read_problem(text), tests::closure_options(formulation, 4));
  };
  const std::string friction = system("0.1*v + 0.2*sign(v) + y") + kNoWall;
  for (const auto formulation : {Formulation::gaussian, Formulation::moment}) {
    EXPECT_EQ(reason(friction + kNoise, formulation), "");
    EXPECT_NE(reason(friction + kImpulses, formulation).find("sticks"), std::string::npos);
    // a force towards a wall, without noise
    EXPECT_NE(reason(system("0.1*v + y + 0*abs(y)") +
                         "[wall]\nleft = 0.5\nleft_restitution = 0.9\n" + kImpulses,
                     formulation)
                  .find("rest"),
              std::string::npos);
  }
  EXPECT_NE(reason(friction + kNoise, Formulation::polar), "");
}

}  // namespace

namespace gaussian {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ProjectedEquations with_formulas(const GaussianWeightedBasis& basis, const Problem& p,
                                 const DensityEquationCoefficients& f) {
  return ProjectedEquations(basis,
                            ProjectedFormulaTerms(basis, p, f.damping, f.odd_force.coefficient(1)));
}

// The residual by quadrature of the formulas is that of the polynomials, for every Q_n.
TEST(ProjectedFormulas, EqualTheResidualOfAHiddenPolynomial) {
  const auto text = [](const std::string& force, const std::string& r) {
    return system(force) + "[wall]\nleft = 0.1\nleft_restitution = " + r + "\n" + kImpulses +
           kNoise;
  };
  const Problem polynomial = read_problem(text("0.2*v + y + 0.3*y^2 + 0.1*y^3", "0.8")),
                formula =
                    read_problem(text("0.2*v + y + 0.3*y^2 + 0.1*y^3 + 0*abs(y-0.7)", "0.8 + 0*v"));
  const StandardDeviations sigma = gaussian_weight_deviations(polynomial);
  for (const auto set : {MonomialSet::point_symmetric, MonomialSet::general}) {
    const GaussianWeightedBasis basis(6, set, sigma);
    const auto f = residual_coefficients(polynomial, problem::DensityEquation::km4),
               of_formula = residual_coefficients(formula, problem::DensityEquation::km4, sigma);
    const ProjectedEquations direct(basis), quadrature = with_formulas(basis, formula, of_formula);
    const VectorXd a = VectorXd::LinSpaced(basis.size(), -0.4, 0.3);
    const VectorXd expected = direct.residual(f, a);
    EXPECT_LT((quadrature.residual(of_formula, a) - expected).norm(), 1e-9 * expected.norm());
    const MatrixXd jacobian = direct.jacobian(f, a);
    EXPECT_LT((quadrature.jacobian(of_formula, a) - jacobian).norm(), 1e-9 * jacobian.norm());
  }
}

TEST(ProjectedFormulas, HaveTheirJacobian) {
  const Problem p =
      read_problem(system("0.2*v + 0.3*v*abs(v) + y + 2*max(y-0.3,0)") +
                   "[wall]\nleft = 0\nleft_restitution = 1 - 0.2*tanh(v)\n" + kImpulses + kNoise +
                   "factor = 1 + 0.3*tanh(y + v)\ninterpretation = stratonovich\n");
  const GaussianWeightedBasis basis(4, MonomialSet::general, gaussian_weight_deviations(p));
  const auto f =
      residual_coefficients(p, problem::DensityEquation::km4, basis.weight_standard_deviations());
  const ProjectedEquations equations = with_formulas(basis, p, f);
  const VectorXd a = VectorXd::LinSpaced(basis.size(), -0.3, 0.2);
  const MatrixXd jacobian = equations.jacobian(f, a);
  constexpr double kStep = 1e-5;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const VectorXd e = kStep * VectorXd::Unit(a.size(), k);
    const VectorXd difference =
        (equations.residual(f, a + e) - equations.residual(f, a - e)) / (2 * kStep);
    EXPECT_LT((jacobian.col(k) - difference).lpNorm<Eigen::Infinity>(),
              1e-6 * (1 + difference.lpNorm<Eigen::Infinity>()))
        << k;
  }
}

}  // namespace
}  // namespace gaussian
}  // namespace fpkcheck::epc
