#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "epc/contact/coordinates.hpp"
#include "general_oscillators.hpp"
#include "half_plane/galerkin_checks.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::ClosureEquations;
using half_plane::OrthonormalBasis;
using half_plane::QuadraturePoints;

constexpr int kContactWallPoints = 40;
constexpr double kRhoMax = 2, kTemperature = 0.6, kRestitution = 0.6;

// Problem with a constant force 0.5 towards the wall and all terms of the damping force.
problem::Problem pressed_mass_problem(const char* law) {
  return tests::with_impulses(
      problem::System({.damping = 0.3,
                       .van_der_pol = 0.2,
                       .rayleigh = 0.1,
                       .constant = 0.5,
                       .stiffness = 1,
                       .cubic = 0.7,
                       .restitution = kRestitution}),
      problem::ImpulseTrain({.arrival_rate = 2, .law = law, .intensity = 0.6, .mean = 0.1}));
}

ClosureEquations contact_equations_of(const problem::Problem& p, int order, int points_each_way,
                                      const half_plane::ExponentConfinementTerm& confinement = {}) {
  const AmplitudeVelocityCoordinates coordinates(p);
  const QuadraturePoints points = amplitude::quadrature_points(
      coordinates, kRhoMax, {}, {points_each_way, points_each_way, kContactWallPoints});
  const OrthonormalBasis basis(order, points, tests::boltzmann_mass(points, kTemperature));
  return amplitude::closure_equations(p, coordinates, kRhoMax, confinement, basis, points,
                                      kContactWallPoints);
}

// Coefficients with a perturbation so small that the atom at the corner keeps its probability.
VectorXd perturbed_contact_coefficients(const ClosureEquations& equations) {
  const VectorXd a = tests::boltzmann_coefficients(equations, kTemperature);
  return a + 0.1 * (tests::perturbed(a) - a);
}

// Direct evaluation of dE[phi]/dt: differences of phi along y' = v, v' = -(f + g), jumps of a
// two-point law, impacts u -> r u of a density with the factor 1/e, and impulses at rest. An impact
// follows an impulse at rest towards the wall.
TEST(ContactEquations, AreTheRatesOfChangeOfTheMeans) {
  const auto p = pressed_mass_problem("two_point");
  const ClosureEquations equations = contact_equations_of(p, 4, 40);
  const AmplitudeVelocityCoordinates coordinates(p);
  const auto& basis = equations.basis();
  const auto& all = equations.points();
  const auto density = equations.evaluate_density(perturbed_contact_coefficients(equations));
  const Eigen::Index moving = all.size() - 1;
  const VectorXd y = all.y.head(moving), v = all.v.head(moving), mass = density.mass.head(moving);
  const auto at = [&](const VectorXd& at_y, const VectorXd& at_v) {
    VectorXd rho(at_y.size());
    for (Eigen::Index i = 0; i < rho.size(); ++i)
      rho[i] = coordinates.amplitude_of(at_y[i], at_v[i]);
    return basis.basis_values(rho, at_v);
  };
  const Eigen::ArrayXd damping =
      (0.3 + 0.2 * y.array().square() + 0.1 * v.array().square()) * v.array();
  const VectorXd force = damping + 0.5 + y.array() + 0.7 * y.array().cube();
  // The time step is so short that no point leaves the half-plane.
  const VectorXd dt = 1e-4 * y.array() / (y.array() + v.array().abs() + 1e-3);
  const VectorXd dy = dt.cwiseProduct(v), dv = -dt.cwiseProduct(force);
  const MatrixXd flow =
      (2 * dt).cwiseInverse().asDiagonal() * (at(y + dy, v + dv) - at(y - dy, v - dv));
  VectorXd expected = flow.transpose() * mass;
  const VectorXd here = VectorXd::Zero(1);
  for (const auto& [amplitude, probability] : p.impulses.amplitude_law().amplitude_atoms()) {
    const VectorXd kicked = v.array() + amplitude;
    expected += 2 * probability * (at(y, kicked) - at(y, v)).transpose() * mass;
    const VectorXd freed =
        VectorXd::Constant(1, amplitude > 0 ? amplitude : -kRestitution * amplitude);
    expected +=
        2 * probability * density.mass[moving] * (at(here, freed) - at(here, here)).transpose();
  }
  const auto wall = numerics::gauss_legendre_rule(kContactWallPoints, 0, kRhoMax);
  const VectorXd zero = VectorXd::Zero(wall.size());
  const MatrixXd change = at(zero, kRestitution * wall.quadrature_points_as_vector()) -
                          at(zero, -wall.quadrature_points_as_vector());
  expected +=
      change.transpose() * wall.quadrature_points_as_vector().cwiseProduct(density.wall_mass);

  const VectorXd residual = equations.residual(density);
  for (Eigen::Index s = 0; s < residual.size(); ++s) {
    EXPECT_NEAR(residual[s], expected[s], 1e-6 * (1 + std::abs(expected[s]))) << s;
  }
  EXPECT_GT(expected.cwiseAbs().minCoeff(), 1e-4);  // the compared rates of change are not 0
  EXPECT_GT(density.mass[moving], 0.01);
}

// The density on the wall is C exp(Q) 2/u^2, and C exp(Q(0, 0)) defines the atom.
TEST(ContactEquations, HaveTheDensityOnTheWallThatBelongsToTheAtom) {
  const auto p = pressed_mass_problem("gaussian");
  const ClosureEquations equations = contact_equations_of(p, 2, 24);
  const VectorXd a = perturbed_contact_coefficients(equations);
  const auto density = equations.evaluate_density(a);
  const double at_rest = density.mass[density.mass.size() - 1];
  const auto wall = numerics::gauss_legendre_rule(kContactWallPoints, 0, kRhoMax);
  const auto exponent = [&](double rho, double v) {
    return equations.basis()
        .basis_values(VectorXd::Constant(1, rho), VectorXd::Constant(1, v))
        .row(0)
        .dot(a);
  };
  for (const int k : {0, 5, 20}) {
    const double u = wall.points[k], p_of_u = density.wall_mass[k] / wall.weights[k];
    // u^2 p -> lambda P0 / ln(1/r)
    EXPECT_NEAR(u * u * p_of_u * std::exp(exponent(0, 0) - exponent(u, -u)),
                2 * at_rest / std::log(1 / kRestitution), 1e-10);
  }
}

TEST(ContactEquations, JacobianIsTheDerivativeOfTheResidual) {
  const auto p = pressed_mass_problem("laplace");
  for (const double level : {std::numeric_limits<double>::infinity(), 1.5}) {
    const ClosureEquations equations =
        contact_equations_of(p, 4, 24, half_plane::ExponentConfinementTerm{level});
    tests::expect_jacobian_is_derivative(equations, perturbed_contact_coefficients(equations));
  }
}

}  // namespace
}  // namespace fpkcheck::epc::contact
