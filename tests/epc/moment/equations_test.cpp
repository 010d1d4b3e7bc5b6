#include "epc/moment/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "epc/moment/homotopy.hpp"
#include "epc/moment/jacobian_check.hpp"
#include "epc/moment/newton.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::moment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using tests::make_problem;

std::vector<double> rate_moments(const problem::Problem& p, int order, int last) {
  std::vector<double> moments(order + 1);
  for (int j = 1; j <= std::min(order, last); ++j) moments[j] = p.impulses.rate_moment(j);
  return moments;
}

// Equations on a domain far out, in a basis of the white-noise density without impact losses.
Equations equations_of(const problem::Problem& p, int order, int last_moment, double deviations,
                       bool confined = false) {
  const double temperature = p.impulses.intensity() / (2 * p.system.damping());
  const double level = temperature * deviations * deviations / 2;
  const EnergyDomain domain(p, level * (confined ? Confinement::reach() : 1));
  const QuadratureSize size{50, 60, 60};
  const Points points = domain.rule(size.y, size.v);
  VectorXd mass(points.y.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    mass[i] = points.weight[i] * std::exp(-domain.energy(points.y[i], points.v[i]) / temperature);
  }
  mass /= mass.sum();
  return {p,
          rate_moments(p, order, last_moment),
          domain,
          confined ? Confinement{level} : Confinement{},
          Basis(order, points, mass),
          size};
}

VectorXd white_noise_exponent(const problem::Problem& p, const Equations& equations) {
  const double beta = 2 * p.system.damping() / p.impulses.intensity();
  const auto& [y, v, weight] = equations.points();
  const VectorXd exponent =
      -beta * (v.array().square() / 2 + p.system.stiffness() * y.array().square() / 2 +
               p.system.cubic() * y.array().pow(4) / 4);
  const VectorXd mass = (weight.array() * exponent.array().exp()).matrix();
  return equations.fit(exponent, mass / mass.sum());
}

TEST(Equations, ExactWhiteNoiseDensityMeetsThemAtAnImpactWithoutLoss) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  for (const int order : {4, 6, 8}) {
    const Equations equations = equations_of(p, order, 2, 10);
    const auto density = equations.density(white_noise_exponent(p, equations));
    EXPECT_LT(equations.residual(density).cwiseAbs().maxCoeff(), 1e-11) << order;
  }
}

// White noise at r < 1: only impacts change the moments of that density, and phi = v^2 loses
// (1 - r^2) int_{v<0} |v|^3 p(0,v) dv per unit time. With beta = c/D2, p(0,v) = p0 exp(-beta v^2/2)
// and the integral is 2 p0 / beta^2.
TEST(Equations, ImpactTakesTheEnergyOfEquationTwo) {
  const auto p = make_problem({.cubic = 0, .restitution = 0.7, .rate = 3, .intensity = 0.4});
  const Equations equations = equations_of(p, 2, 2, 10);
  const auto density = equations.density(white_noise_exponent(p, equations));
  const VectorXd residual = equations.residual(density);
  const double beta = 2 * 0.1 / 0.4;
  // int exp(-beta (v^2 + y^2)/2) over y > 0 is pi / beta.
  const double expected = -(1 - 0.49) * 2 / (beta * beta) * beta / M_PI;
  // phi = v^2 in the basis: g_2 = (v^2 - sigma^2)/(sqrt(2) sigma^2), sigma^2 = 1/beta, the third of
  // the second degree's members (y^2, y v, v^2).
  EXPECT_NEAR(residual[4] * std::sqrt(2.0) / beta, expected, 1e-8);
}

// d E[phi]/dt of the impulses alone, lambda E[phi(v + Y) - phi(v)], by brute force for a two-point
// law: all moments of Y enter, the odd ones with a mean.
TEST(Equations, ImpulsesChangeTheMomentsAsJumpsDo) {
  const auto p = make_problem({.damping = 1e-9,
                               .stiffness = 1,
                               .cubic = 0,
                               .restitution = 1,
                               .rate = 2,
                               .intensity = 0.6,
                               .mean = 0.2,
                               .law = "two_point"});
  const EnergyDomain domain(p, 20);
  const QuadratureSize size{50, 60, 60};
  const Points points = domain.rule(size.y, size.v);
  VectorXd mass = (-points.v.array().square() - (points.y.array() - 0.4).square()).exp();
  mass = mass.cwiseProduct(points.weight);
  mass /= mass.sum();
  const int order = 5;
  const Basis basis(order, points, mass);
  const auto moments = rate_moments(p, order, order);
  const Equations with(p, moments, domain, {}, basis, size);
  const Equations without(p, std::vector<double>(order + 1), domain, {}, basis, size);
  const VectorXd a = VectorXd::Zero(basis.size());  // constant density: any will do
  const VectorXd change = with.residual(with.density(a)) - without.residual(without.density(a));

  const auto density = with.density(a);
  VectorXd expected = VectorXd::Zero(basis.size());
  for (const auto& [amplitude, probability] : p.impulses.law().atoms()) {
    const VectorXd kicked = points.v.array() + amplitude;
    expected += 2 * probability *
                (basis.values(points.y, kicked) - basis.values(points.y, points.v)).transpose() *
                density.mass;
  }
  for (Eigen::Index s = 0; s < basis.size(); ++s) {
    EXPECT_NEAR(change[s], expected[s], 1e-8 * (1 + std::abs(expected[s]))) << s;
  }
}

// Up to a constant, which the density does not know.
TEST(Equations, AFitRecoversAPolynomialExponent) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  const Equations equations = equations_of(p, 4, 2, 6);
  const VectorXd a = VectorXd::LinSpaced(14, -0.3, 0.4);
  const auto& [y, v, weight] = equations.points();
  const VectorXd exponent = (equations.basis().values(y, v) * a).array() + 5.0;
  const VectorXd mass = VectorXd::Constant(y.size(), 1.0 / static_cast<double>(y.size()));
  EXPECT_LT((equations.fit(exponent, mass) - a).cwiseAbs().maxCoeff(), 1e-9);
  const Polynomial q = equations.basis().polynomial(a);
  EXPECT_NEAR(q(y[7], v[7]) - q(y[900], v[900]), exponent[7] - exponent[900], 1e-9);
}

TEST(Equations, JacobianIsTheDerivativeOfTheResidual) {
  const auto p = make_problem({.restitution = 0.8, .mean = 0.1, .law = "laplace"});
  for (const bool confined : {false, true}) {
    const Equations equations = equations_of(p, 4, 4, 5, confined);
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0, 0.05);
    VectorXd a = white_noise_exponent(p, equations);
    for (double& x : a) x += normal(engine);
    tests::expect_jacobian_is_derivative(equations, a);
  }
}

TEST(Equations, CovarianceIsThatOfTheMembers) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  const Equations equations = equations_of(p, 4, 2, 10);
  const auto density = equations.density(white_noise_exponent(p, equations));
  const MatrixXd covariance = equations.covariance(density);
  // y and v are independent, so that products of orthonormal polynomials are orthonormal.
  EXPECT_LT((covariance - MatrixXd::Identity(14, 14)).cwiseAbs().maxCoeff(), 1e-10);
}

// From the density without losses at r = 0.98 to one at r = 0.6.
TEST(Homotopy, LeadsToTheRootThatNewtonFinds) {
  const auto p = make_problem({.restitution = 0.6});
  const Equations equations = equations_of(p, 4, 4, 6, true);
  const VectorXd start = white_noise_exponent(p, equations);
  const auto direct = newton(equations, start, p.system.damping(), {.polish = true});
  ASSERT_TRUE(direct.converged);
  const auto path = follow_homotopy(equations, start);
  ASSERT_EQ(path.reached, 1);
  EXPECT_GT(path.steps, 3);  // it is far
  const auto refined = newton(equations, path.a, p.system.damping(), {.polish = true});
  ASSERT_TRUE(refined.converged);
  EXPECT_LT((refined.a - direct.a).norm(), 1e-9);
}

TEST(MomentNewton, SizeDoesNotDependOnTheBasis) {
  VectorXd residual(3);
  residual << 0.3, -0.1, 0.2;
  MatrixXd covariance = MatrixXd::Identity(3, 3);
  covariance(0, 1) = covariance(1, 0) = 0.4;
  MatrixXd change(3, 3);  // phi' = change * phi
  change << 2, 0, 1, 0.5, 1, 0, 0, -1, 3;
  EXPECT_NEAR(size_of(change * residual, change * covariance * change.transpose(), 0.1),
              size_of(residual, covariance, 0.1), 1e-13);
  EXPECT_NEAR(size_of(residual, MatrixXd::Identity(3, 3), 0.1), residual.norm() / 0.1, 1e-13);
}

}  // namespace
}  // namespace fpkcheck::epc::moment
