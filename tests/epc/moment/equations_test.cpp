#include "epc/moment/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "general_oscillators.hpp"
#include "half_plane/galerkin_checks.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::moment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::ClosureEquations;
using half_plane::ExponentConfinementTerm;
using half_plane::OrthonormalBasis;
using half_plane::QuadraturePoints;
using tests::make_problem;

std::vector<double> rates_times_moments(const problem::Problem& p, int order, int last) {
  std::vector<double> moments(order + 1);
  for (int j = 1; j <= std::min(order, last); ++j) moments[j] = p.impulses.rate_times_moment(j);
  return moments;
}

constexpr int kWallPoints = 60;
QuadraturePoints points_of(const EnergySublevelSet& domain) {
  return domain.quadrature_points(50, 60);
}

// The equations on a large domain, in a basis orthonormal under the elastic white-noise density.
ClosureEquations make_moment_equations(const problem::Problem& p, int order, int last_moment,
                                       double deviations, bool confined = false) {
  const double temperature = tests::temperature_of(p);
  const double level = temperature * deviations * deviations / 2;
  const EnergySublevelSet domain(
      p, level * (confined ? ExponentConfinementTerm::support_to_level_ratio() : 1));
  const QuadraturePoints points = points_of(domain);
  const OrthonormalBasis basis(order, points, tests::boltzmann_mass(points, temperature));
  return closure_equations(p, rates_times_moments(p, order, last_moment), domain,
                           confined ? ExponentConfinementTerm{level} : ExponentConfinementTerm{},
                           basis, points, kWallPoints);
}

VectorXd white_noise_exponent(const problem::Problem& p, const ClosureEquations& equations) {
  return tests::boltzmann_coefficients(equations, tests::temperature_of(p));
}

TEST(MomentEquations, ExactWhiteNoiseDensityMeetsThemAtAnImpactWithoutLoss) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  for (const int order : {4, 6, 8}) {
    const ClosureEquations equations = make_moment_equations(p, order, 2, 10);
    const auto density = equations.evaluate_density(white_noise_exponent(p, equations));
    EXPECT_LT(equations.residual(density).cwiseAbs().maxCoeff(), 1e-11) << order;
  }
}

// White noise at r < 1: only impacts change the moments of the elastic density. E[v^2] decreases by
// (1 - r^2) int_{v<0} |v|^3 p(0,v) dv per unit time. With beta = c/D2, p(0,v) = p0 exp(-beta v^2/2)
// and the integral is 2 p0 / beta^2.
TEST(MomentEquations, ImpactTakesTheEnergyOfEquationTwo) {
  const auto p = make_problem({.cubic = 0, .restitution = 0.7, .rate = 3, .intensity = 0.4});
  const ClosureEquations equations = make_moment_equations(p, 2, 2, 10);
  const auto density = equations.evaluate_density(white_noise_exponent(p, equations));
  const VectorXd residual = equations.residual(density);
  const double beta = 2 * 0.1 / 0.4;
  // int exp(-beta (v^2 + y^2)/2) over y > 0 is pi / beta.
  const double expected = -(1 - 0.49) * 2 / (beta * beta) * beta / M_PI;
  // v^2 in the basis: g_2 = (v^2 - sigma^2)/(sqrt(2) sigma^2), sigma^2 = 1/beta, which is the third
  // member of degree 2 (y^2, y v, v^2).
  EXPECT_NEAR(residual[4] * std::sqrt(2.0) / beta, expected, 1e-8);
}

// d E[phi]/dt by the impulses alone, lambda E[phi(v + Y) - phi(v)], evaluated directly for a
// two-point law. All moments of Y contribute; with a mean of Y the odd moments are nonzero.
TEST(MomentEquations, ImpulsesChangeTheMomentsAsJumpsDo) {
  const auto p = make_problem({.damping = 1e-9,
                               .stiffness = 1,
                               .cubic = 0,
                               .restitution = 1,
                               .rate = 2,
                               .intensity = 0.6,
                               .mean = 0.2,
                               .law = "two_point"});
  const EnergySublevelSet domain(p, 20);
  const QuadraturePoints points = points_of(domain);
  VectorXd mass = (-points.v.array().square() - (points.y.array() - 0.4).square()).exp();
  mass = mass.cwiseProduct(points.weight);
  mass /= mass.sum();
  const int order = 5;
  const OrthonormalBasis basis(order, points, mass);
  const auto moments = rates_times_moments(p, order, order);
  const ClosureEquations with =
      closure_equations(p, moments, domain, {}, basis, points, kWallPoints);
  const ClosureEquations without =
      closure_equations(p, std::vector<double>(order + 1), domain, {}, basis, points, kWallPoints);
  const VectorXd a = VectorXd::Zero(basis.size());  // constant density, an arbitrary choice
  const VectorXd change =
      with.residual(with.evaluate_density(a)) - without.residual(without.evaluate_density(a));

  const auto density = with.evaluate_density(a);
  VectorXd expected = VectorXd::Zero(basis.size());
  for (const auto& [amplitude, probability] : p.impulses.amplitude_law().amplitude_atoms()) {
    const VectorXd kicked = points.v.array() + amplitude;
    expected += 2 * probability *
                (basis.basis_values(points.y, kicked) - basis.basis_values(points.y, points.v))
                    .transpose() *
                density.mass;
  }
  for (Eigen::Index s = 0; s < basis.size(); ++s) {
    EXPECT_NEAR(change[s], expected[s], 1e-8 * (1 + std::abs(expected[s]))) << s;
  }
}

// The fit reproduces an exponent up to a constant, which the normalisation removes.
TEST(MomentEquations, AFitRecoversAPolynomialExponent) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  const ClosureEquations equations = make_moment_equations(p, 4, 2, 6);
  const VectorXd a = VectorXd::LinSpaced(14, -0.3, 0.4);
  const VectorXd &y = equations.points().y, &v = equations.points().v;
  const VectorXd exponent = (equations.basis().basis_values(y, v) * a).array() + 5.0;
  const VectorXd mass = VectorXd::Constant(y.size(), 1.0 / static_cast<double>(y.size()));
  EXPECT_LT((equations.fit_exponent_coefficients(exponent, mass) - a).cwiseAbs().maxCoeff(), 1e-9);
  const ExponentPolynomial q = equations.basis().exponent_polynomial(a);
  EXPECT_NEAR(q(y[7], v[7]) - q(y[900], v[900]), exponent[7] - exponent[900], 1e-9);
}

TEST(MomentEquations, JacobianIsTheDerivativeOfTheResidual) {
  const auto p = make_problem({.restitution = 0.8, .mean = 0.1, .law = "laplace"});
  for (const bool confined : {false, true}) {
    const ClosureEquations equations = make_moment_equations(p, 4, 4, 5, confined);
    tests::expect_jacobian_is_derivative(equations,
                                         tests::perturbed(white_noise_exponent(p, equations)));
  }
}

TEST(MomentEquations, CovarianceIsThatOfTheMembers) {
  const auto p = make_problem({.restitution = 1, .rate = 3, .intensity = 0.4});
  const ClosureEquations equations = make_moment_equations(p, 4, 2, 10);
  const auto density = equations.evaluate_density(white_noise_exponent(p, equations));
  const MatrixXd covariance = equations.covariance(density);
  // y and v are independent: products of orthonormal polynomials are orthonormal.
  EXPECT_LT((covariance - MatrixXd::Identity(14, 14)).cwiseAbs().maxCoeff(), 1e-10);
}

problem::Problem problem_between_walls(double r_left, double r_right) {
  return tests::with_noise(
      problem::System(
          {.damping = 0.1, .stiffness = 1},
          {.left = 0, .left_restitution = r_left, .right = 1.5, .right_restitution = r_right}),
      0.4);
}

ClosureEquations make_equations_between_walls(const problem::Problem& p, int order,
                                              double temperature) {
  const EnergySublevelSet domain(p, temperature * 50);
  const QuadraturePoints points = points_of(domain);
  const OrthonormalBasis basis(order, points, tests::boltzmann_mass(points, temperature));
  return closure_equations(p, std::vector<double>(order + 1), domain, {}, basis, points,
                           kWallPoints);
}

// exp(-h/T), T = D/c = 2, between walls: stationary if both walls are elastic. At an inelastic wall
// E[v^2] decreases by (1 - r^2) int u^3 p(wall, u) du = (1 - r^2) 2 T^2 p(wall, 0) per unit time.
TEST(MomentEquations, EachWallDissipatesItsOwnPower) {
  const double temperature = 2;
  const auto energy_lost = [&](double r_left, double r_right) {
    const ClosureEquations equations =
        make_equations_between_walls(problem_between_walls(r_left, r_right), 2, temperature);
    const auto density =
        equations.evaluate_density(tests::boltzmann_coefficients(equations, temperature));
    const VectorXd residual = equations.residual(density);
    const bool lossless = r_left == 1 && r_right == 1;
    EXPECT_EQ(residual.cwiseAbs().maxCoeff() < 1e-11, lossless);
    return -residual[4] * std::sqrt(2.0) * temperature;  // v^2 in the basis, as above
  };
  const double norm = std::sqrt(2 * M_PI * temperature) * std::sqrt(M_PI * temperature / 2) *
                      std::erf(1.5 / std::sqrt(2 * temperature));
  const double flux = 2 * temperature * temperature / norm;
  EXPECT_NEAR(energy_lost(1, 1), 0, 1e-10);
  EXPECT_NEAR(energy_lost(0.7, 1), 0.51 * flux, 1e-8);
  EXPECT_NEAR(energy_lost(1, 0.8), 0.36 * flux * std::exp(-1.125 / temperature), 1e-8);
}

TEST(MomentEquations, JacobianIsTheDerivativeOfTheResidualBetweenWalls) {
  const auto p = problem_between_walls(0.7, 0.9);
  const ClosureEquations equations = make_equations_between_walls(p, 4, 2);
  tests::expect_jacobian_is_derivative(
      equations, tests::perturbed(tests::boltzmann_coefficients(equations, 2)));
}

}  // namespace
}  // namespace fpkcheck::epc::moment
