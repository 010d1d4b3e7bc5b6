#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "epc/half_plane/galerkin_system.hpp"
#include "problem/problem.hpp"

/// Helpers for the tests of Galerkin equations in any coordinates.
namespace fpkcheck::tests {

/// Returns the temperature T = D2/c of the exact density C exp(-h/T) under white noise with elastic
/// impacts.
inline double temperature_of(const problem::Problem& p) {
  return p.impulses.intensity() / (2 * p.system.damping());
}

/// Returns the probabilities of the density C exp(-h/T) at quadrature points; the sum is 1.
inline Eigen::VectorXd boltzmann_mass(const epc::half_plane::QuadraturePoints& points,
                                      double temperature) {
  const Eigen::VectorXd mass = points.weight.array() * (-points.energy.array() / temperature).exp();
  return mass / mass.sum();
}

/// Returns the coefficients, in the basis, of the exponent of C exp(-h/T).
inline Eigen::VectorXd boltzmann_coefficients(const epc::half_plane::ClosureEquations& equations,
                                              double temperature) {
  const auto& points = equations.points();
  return equations.fit_exponent_coefficients(-points.energy / temperature,
                                             boltzmann_mass(points, temperature));
}

/// Returns the coefficients plus a random perturbation that removes all symmetries.
inline Eigen::VectorXd perturbed(Eigen::VectorXd a) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(0, 0.05);
  for (double& x : a) x += normal(engine);
  return a;
}

/// Compares the analytic Jacobian of Galerkin equations with central differences of the residual.
inline void expect_jacobian_is_derivative(const epc::half_plane::GalerkinSystem& equations,
                                          const Eigen::VectorXd& a) {
  constexpr double kStep = 1e-5;
  const Eigen::MatrixXd jacobian = equations.jacobian(equations.evaluate_density(a));
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(a.size(), k);
    const Eigen::VectorXd difference = (equations.residual(equations.evaluate_density(a + e)) -
                                        equations.residual(equations.evaluate_density(a - e))) /
                                       (2 * kStep);
    EXPECT_LT((jacobian.col(k) - difference).cwiseAbs().maxCoeff(),
              1e-7 * (1 + difference.cwiseAbs().maxCoeff()))
        << k;
  }
}

}  // namespace fpkcheck::tests
