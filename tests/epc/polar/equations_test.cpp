#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "epc/polar/coordinates.hpp"
#include "half_plane/galerkin_checks.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::ClosureEquations;
using half_plane::OrthonormalBasis;
using half_plane::QuadraturePoints;
using tests::make_problem;

constexpr int kWallPoints = 40;

double rho_max_of(const problem::Problem& p) { return 8 * std::sqrt(tests::temperature_of(p)); }

// The equations up to eight deviations, in a basis that is orthonormal under the density for white
// noise with elastic impacts.
ClosureEquations make_polar_equations(const problem::Problem& p, int order, int points_each_way,
                                      const half_plane::ExponentConfinementTerm& confinement = {}) {
  const AmplitudePhaseCoordinates coordinates(p);
  const double rho_max = rho_max_of(p);
  const QuadraturePoints points = amplitude::quadrature_points(
      coordinates, rho_max,
      AmplitudePhaseCoordinates::amplitude_break_points(p.impulses.amplitude_law(), rho_max),
      {points_each_way, points_each_way, kWallPoints});
  const OrthonormalBasis basis(order, points,
                               tests::boltzmann_mass(points, tests::temperature_of(p)));
  return amplitude::closure_equations(p, coordinates, rho_max, confinement, basis, points,
                                      kWallPoints);
}

VectorXd perturbed_coefficients(const problem::Problem& p, const ClosureEquations& equations) {
  return tests::perturbed(tests::boltzmann_coefficients(equations, tests::temperature_of(p)));
}

// Direct evaluation of dE[phi]/dt: differences of phi along y' = v, v' = -c v - k y - mu y^3, jumps
// of a two-point law, and impacts rho -> r rho, theta: -pi/2 -> pi/2.
TEST(PolarEquations, AreTheRatesOfChangeOfTheMeans) {
  for (const double stiffness : {0.0, 1.0}) {
    const auto p = make_problem({.damping = 0.3,
                                 .stiffness = stiffness,
                                 .cubic = 0.7,
                                 .restitution = 0.6,
                                 .rate = 2,
                                 .intensity = 0.6,
                                 .mean = 0.2,
                                 .law = "two_point"});
    const ClosureEquations equations = make_polar_equations(p, 4, 40);
    const AmplitudePhaseCoordinates coordinates(p);
    const auto& basis = equations.basis();
    const auto& points = equations.points();
    const auto density = equations.evaluate_density(perturbed_coefficients(p, equations));
    const auto at = [&](const VectorXd& y, const VectorXd& v) {
      VectorXd rho(y.size()), theta(y.size());
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        rho[i] = coordinates.amplitude_of(y[i], v[i]);
        theta[i] = coordinates.phase_of(y[i], v[i]);
      }
      return basis.basis_values(rho, theta);
    };
    const VectorXd force =
        0.3 * points.v.array() + stiffness * points.y.array() + 0.7 * points.y.array().cube();
    // A time step that changes the phase by 1e-4 at every point.
    const VectorXd dt =
        1e-4 * points.s.cwiseQuotient((points.v.cwiseAbs2() + force.cwiseAbs2()).cwiseSqrt());
    const VectorXd dy = dt.cwiseProduct(points.v), dv = -dt.cwiseProduct(force);
    const MatrixXd flow = (2 * dt).cwiseInverse().asDiagonal() *
                          (at(points.y + dy, points.v + dv) - at(points.y - dy, points.v - dv));
    VectorXd expected = flow.transpose() * density.mass;
    for (const auto& [amplitude, probability] : p.impulses.amplitude_law().amplitude_atoms()) {
      const VectorXd kicked = points.v.array() + amplitude;
      expected += 2 * probability * (at(points.y, kicked) - at(points.y, points.v)).transpose() *
                  density.mass;
    }
    const auto wall = numerics::gauss_legendre_rule(kWallPoints, 0, rho_max_of(p));
    const VectorXd zero = VectorXd::Zero(wall.size());
    const VectorXd down = VectorXd::Constant(wall.size(), -M_PI / 2);
    const MatrixXd change = at(zero, 0.6 * wall.quadrature_points_as_vector()) -
                            basis.basis_values(wall.quadrature_points_as_vector(), down);
    expected +=
        change.transpose() * wall.quadrature_points_as_vector().cwiseProduct(density.wall_mass);

    const VectorXd residual = equations.residual(density);
    for (Eigen::Index s = 0; s < residual.size(); ++s) {
      EXPECT_NEAR(residual[s], expected[s], 1e-6 * (1 + std::abs(expected[s]))) << s;
    }
    EXPECT_GT(expected.cwiseAbs().minCoeff(), 1e-4);  // the compared rates of change are not 0
  }
}

TEST(PolarEquations, JacobianIsTheDerivativeOfTheResidual) {
  const auto p = make_problem({.restitution = 0.8, .mean = 0.1, .law = "laplace"});
  for (const double level : {std::numeric_limits<double>::infinity(), 8.0}) {
    const ClosureEquations equations =
        make_polar_equations(p, 4, 24, half_plane::ExponentConfinementTerm{level});
    tests::expect_jacobian_is_derivative(equations, perturbed_coefficients(p, equations));
  }
}

// Amplitudes from which an impulse of the two-point law stops the mass at the wall.
TEST(PolarEquations, BreakWhereAnAtomMayStopTheMass) {
  const auto law = problem::ImpulseLaw::from_name("two_point", 0.2, 0.5);
  EXPECT_EQ(AmplitudePhaseCoordinates::amplitude_break_points(law, 10).size(), 2u);
  EXPECT_NEAR(AmplitudePhaseCoordinates::amplitude_break_points(law, 10)[0], 0.3, 1e-15);
  EXPECT_NEAR(AmplitudePhaseCoordinates::amplitude_break_points(law, 10)[1], 0.7, 1e-15);
  EXPECT_EQ(AmplitudePhaseCoordinates::amplitude_break_points(law, 0.5).size(), 1u);
  EXPECT_EQ(AmplitudePhaseCoordinates::amplitude_break_points(
                problem::ImpulseLaw::from_name("two_point", 0, 0.5), 10)
                .size(),
            1u);
  EXPECT_TRUE(AmplitudePhaseCoordinates::amplitude_break_points(
                  problem::ImpulseLaw::from_name("gaussian", 0.2, 0.5), 10)
                  .empty());
}

}  // namespace
}  // namespace fpkcheck::epc::polar
