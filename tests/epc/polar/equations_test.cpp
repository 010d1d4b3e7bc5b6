#include "epc/polar/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "epc/moment/energy_domain.hpp"
#include "epc/moment/jacobian_check.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using tests::make_problem;

// Equations out to eight deviations, in a basis of the white-noise density without losses.
Equations equations_of(const problem::Problem& p, int order, const QuadratureSize& size,
                       const moment::Confinement& confinement = {}) {
  const Coordinates coordinates(p);
  const double temperature = p.impulses.intensity() / (2 * p.system.damping());
  const double rho_max = 8 * std::sqrt(temperature);
  const Points points = rule(coordinates, rho_max, breaks_of(p.impulses.law(), rho_max), size);
  VectorXd mass = points.weight.array() * (-points.rho.array().square() / 2 / temperature).exp();
  mass /= mass.sum();
  return {p, coordinates, rho_max, confinement, basis_of(order, points, mass), size};
}

// Coefficients near those of the density of white noise, which has no symmetry left.
VectorXd some_density(const problem::Problem& p, const Equations& equations) {
  const double temperature = p.impulses.intensity() / (2 * p.system.damping());
  const VectorXd exponent = -equations.points().rho.array().square() / (2 * temperature);
  const VectorXd mass = (equations.points().weight.array() * exponent.array().exp()).matrix();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(0, 0.05);
  VectorXd a = equations.fit(exponent, mass / mass.sum());
  for (double& x : a) x += normal(engine);
  return a;
}

TEST(Coordinates, AreInverseToEachOther) {
  for (const double stiffness : {0.0, 1.0}) {
    const auto p = make_problem({.stiffness = stiffness, .cubic = 0.7});
    const Coordinates coordinates(p);
    for (const double y : {0.0, 1e-8, 0.3, 5.0}) {
      EXPECT_NEAR(coordinates.y(coordinates.w(y)), y, 1e-14 * (1 + y));
      const double h = 1e-5;
      EXPECT_NEAR(coordinates.slope(y), (coordinates.w(y + h) - coordinates.w(y - h)) / (2 * h),
                  1e-8);
      if (y > 0) {
        EXPECT_NEAR(coordinates.force_by_w(y) * coordinates.w(y) / p.system.restoring_force(y), 1,
                    1e-14);
      }
    }
  }
  // With a stiffness of its own the amplitude is that of the energy.
  const auto p = make_problem({.cubic = 0.7});
  EXPECT_NEAR(std::pow(Coordinates(p).rho(0.6, -0.8), 2) / 2,
              0.32 + 0.18 + 0.7 * std::pow(0.6, 4) / 4, 1e-15);
}

TEST(PolarRule, HasTheAreaAndTheMomentsOfTheHalfDisc) {
  const auto p = make_problem({.cubic = 0});
  for (const std::vector<double>& breaks : {std::vector<double>{}, {0.4, 1.1}}) {
    const Points points = rule(Coordinates(p), 2, breaks, {24, 24});
    EXPECT_NEAR(points.weight.sum(), M_PI * 2, 1e-12);
    EXPECT_NEAR(points.weight.dot(points.y), 2.0 / 3 * 8, 1e-12);
    EXPECT_NEAR(points.weight.dot(points.v.cwiseAbs2()), M_PI * 16 / 8, 1e-12);
  }
}

// dE[phi]/dt by hand: along y' = v, v' = -c v - k y - mu y^3 by differences of phi, by the jumps of
// a two-point law, and by the impacts rho -> r rho, theta: -pi/2 -> pi/2.
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
    const QuadratureSize size{40, 40};
    const Equations equations = equations_of(p, 4, size);
    const Coordinates coordinates(p);
    const auto& basis = equations.basis();
    const auto& points = equations.points();
    const auto density = equations.density(some_density(p, equations));
    const auto at = [&](const VectorXd& y, const VectorXd& v) {
      VectorXd rho(y.size()), theta(y.size());
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        rho[i] = coordinates.rho(y[i], v[i]);
        theta[i] = coordinates.theta(y[i], v[i]);
      }
      return basis.values(rho, theta);
    };
    const VectorXd force =
        0.3 * points.v.array() + stiffness * points.y.array() + 0.7 * points.y.array().cube();
    // A step that turns the phase by 1e-4 wherever the point lies.
    const VectorXd dt =
        1e-4 * points.rho.cwiseQuotient((points.v.cwiseAbs2() + force.cwiseAbs2()).cwiseSqrt());
    const VectorXd dy = dt.cwiseProduct(points.v), dv = -dt.cwiseProduct(force);
    const MatrixXd flow = (2 * dt).cwiseInverse().asDiagonal() *
                          (at(points.y + dy, points.v + dv) - at(points.y - dy, points.v - dv));
    VectorXd expected = flow.transpose() * density.mass;
    for (const auto& [amplitude, probability] : p.impulses.law().atoms()) {
      const VectorXd kicked = points.v.array() + amplitude;
      expected += 2 * probability * (at(points.y, kicked) - at(points.y, points.v)).transpose() *
                  density.mass;
    }
    const double rho_max = 8 * std::sqrt(p.impulses.intensity() / 0.6);
    const moment::Line wall = moment::legendre_rule(size.rho, 0, rho_max);
    const VectorXd zero = VectorXd::Zero(wall.at.size());
    const VectorXd down = VectorXd::Constant(wall.at.size(), -M_PI / 2);
    const MatrixXd change = at(zero, 0.6 * wall.at) - basis.values(wall.at, down);
    expected += change.transpose() * wall.at.cwiseProduct(density.wall_mass);

    const VectorXd residual = equations.residual(density);
    for (Eigen::Index s = 0; s < residual.size(); ++s) {
      EXPECT_NEAR(residual[s], expected[s], 1e-6 * (1 + std::abs(expected[s]))) << s;
    }
    EXPECT_GT(expected.cwiseAbs().minCoeff(), 1e-4);  // nothing is compared with nothing
  }
}

TEST(PolarEquations, JacobianIsTheDerivativeOfTheResidual) {
  const auto p = make_problem({.restitution = 0.8, .mean = 0.1, .law = "laplace"});
  for (const double level : {std::numeric_limits<double>::infinity(), 8.0}) {
    const Equations equations = equations_of(p, 4, {24, 24}, moment::Confinement{level});
    const VectorXd a = some_density(p, equations);
    tests::expect_jacobian_is_derivative(equations, a);
  }
}

}  // namespace
}  // namespace fpkcheck::epc::polar
