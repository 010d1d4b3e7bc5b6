#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "epc/amplitude/amplitude_phase.hpp"
#include "epc/amplitude/impulse_means.hpp"
#include "epc/form/exponent_polynomial.hpp"
#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/galerkin_system.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

/// Quadrature points, moment equations, density and contours of the formulations whose first
/// coordinate s is the amplitude. The template parameter `Coordinates` is
/// polar::AmplitudePhaseCoordinates or contact::AmplitudeVelocityCoordinates, with these functions:
///  - sqrt_twice_potential(y), the speed w(y); displacement(w), its inverse function;
///    displacement_slope(y), the derivative dy/dw;
///  - second_exponent_coordinate(rho, theta), the coordinate t; phase(rho, t), its inverse function;
///  - coordinates_after_impulse(w, v), the coordinates s and t of the velocity v after an impulse;
///  - coordinate_time_derivatives(system, y, rho, t), the rates of change of s and t;
///  - coordinate_derivatives_in_v(rho, t), the derivatives of s and t with respect to v;
///  - density_prefactor(rho), the factor of the exponential in the density;
///  - relative_atom_probability(), the probability of the atom at rest divided by C exp(Q_n);
///  - amplitude_break_points(law, rho_max), amplitudes at which quadrature panels end;
///  - phases_for_leading_form_sign(), the phases at which the sign of the leading form may differ.
namespace fpkcheck::epc::amplitude {

/// Derivatives of the two coordinates s and t of a closure (amplitude, and phase or velocity) in
/// time, or in the velocity v.
struct CoordinateTimeDerivatives {
  double s, t;
};

/// Returns the polynomial q as a function of amplitude and phase, with a reference to q.
template <class Coordinates>
ExponentInPolarCoordinates polar_exponent(const ExponentPolynomial& q) {
  return [&q](double rho, double theta) {
    return q(rho, Coordinates::second_exponent_coordinate(rho, theta));
  };
}

/// Returns Gauss-Legendre points in amplitude rho and phase theta, where v = rho sin(theta). The
/// quadrature weights include the factor by which the density differs from C exp(Q_n). If the
/// stationary law has an atom at rest, the last quadrature point is the atom.
/// @param breaks increasing amplitudes between 0 and rho_max at which a panel in rho ends
/// @param size numbers of points: s in rho, with additional points near the breaks, and t in theta
template <class Coordinates>
half_plane::QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                               const std::vector<double>& breaks,
                                               const half_plane::QuadraturePointCounts& size) {
  const auto rho = piecewise_gauss_legendre_rule(rho_max, breaks, size.s);
  const auto theta =
      numerics::gauss_legendre_rule(size.t, -std::numbers::pi / 2, std::numbers::pi / 2);
  const bool has_atom = coordinates.relative_atom_probability() > 0;
  auto points =
      half_plane::QuadraturePoints::zero_initialised(rho.size() * theta.size() + has_atom);
  Eigen::Index k = 0;
  for (std::size_t i = 0; i < rho.points.size(); ++i) {
    const double at = rho.points[i];
    for (std::size_t j = 0; j < theta.points.size(); ++j, ++k) {
      points.s[k] = at;
      points.t[k] = Coordinates::second_exponent_coordinate(at, theta.points[j]);
      points.y[k] = coordinates.displacement(at * std::cos(theta.points[j]));
      points.v[k] = at * std::sin(theta.points[j]);
      points.energy[k] = energy_of_amplitude(at);
      // The area element in amplitude rho and phase theta is dy dv = (dy/dw) dw dv = (dy/dw) rho
      // drho dtheta, with w = rho cos(theta).
      points.weight[k] = rho.weights[i] * theta.weights[j] * at *
                         coordinates.displacement_slope(points.y[k]) *
                         Coordinates::density_prefactor(at);
    }
  }
  if (has_atom) points.weight[k] = coordinates.relative_atom_probability();
  return points;
}

/// Returns the contour of constant amplitude rho, as points at different phases. The areas of the
/// contour points include the factor by which the density differs from C exp(Q_n).
template <class Coordinates>
half_plane::DensityContour constant_amplitude_contour(const Coordinates& coordinates, double rho) {
  // The area A(h) inside the contour of the energy h has the derivative dA/dh = integral of (dy/dw)
  // dtheta, with w = rho cos(theta).
  half_plane::DensityContour contour;
  for (int k = 0; k < kPhaseCount; ++k) {
    const double theta = equidistant_phases()[k];
    const double y = coordinates.displacement(rho * std::cos(theta));
    contour.push_back({.s = rho,
                       .t = Coordinates::second_exponent_coordinate(rho, theta),
                       .y = y,
                       .v = rho * std::sin(theta),
                       .area = trapezoidal_phase_weight(k) * coordinates.displacement_slope(y) *
                               Coordinates::density_prefactor(rho)});
  }
  return contour;
}

/// Returns the density with the exponent q + confinement term as a function of y and v.
/// @param support energy above which the density is 0
template <class Coordinates>
transform::SmoothDensity density_from_exponent(
    const ExponentPolynomial& q, const Coordinates& coordinates, double support,
    const half_plane::ExponentConfinementTerm& confinement, double log_constant) {
  const double largest = amplitude_of_energy(support);
  return {.value =
              [q, coordinates, largest, confinement, log_constant](double y, double v) {
                if (y < 0) return 0.0;
                const auto [rho, t] = coordinates.coordinates_of_state(y, v);
                if (rho > largest) return 0.0;
                return Coordinates::density_prefactor(rho) *
                       std::exp(q(rho, t) + confinement(energy_of_amplitude(rho)) + log_constant);
              },
          .y_max = coordinates.displacement(largest),
          .v_max = largest};
}

/// Determines the behaviour of the exponent Q_n at infinity by condition (19) of the paper, along
/// the phases of Coordinates::phases_for_leading_form_sign(). The radii in the result are
/// amplitudes in units of sigma_2, the standard deviation of the velocity.
template <class Coordinates>
ExponentBehaviourAtInfinity leading_form_of_amplitude_exponent(const ExponentPolynomial& q,
                                                               const StandardDeviations& sigma) {
  std::vector<PhasePlaneDirection> directions;
  for (const double theta : Coordinates::phases_for_leading_form_sign())
    directions.push_back({1, Coordinates::second_exponent_coordinate(1, theta)});
  return leading_form_along_directions(q, directions, sigma.x2);
}

/// Returns the Galerkin equations of the impact process for the functions h_p(rho) g_q(t), 1 <= p +
/// q <= n, of the amplitude rho and a second coordinate t. The motion between impulses and the
/// impulses Y of arrival rate lambda change the mean of a basis function phi at the rate
///
///     L*phi = rho' phi_rho + t' phi_t + lambda ( E[phi(y, v + Y)] - phi ).
///
/// If the mass rests in contact with the wall, each impulse towards the wall causes an impact at
/// once. In the coordinates amplitude and phase the basis functions phi have a jump at y = v = 0,
/// but all terms of the moment equations are bounded. Under white noise the Galerkin equations in
/// amplitude and phase do not exist, since d^2 theta/dv^2 is not integrable. If rho^2/2 is the
/// energy, the closure satisfies the balance of power exactly, since the basis contains rho^2/2.
/// @param points quadrature points up to the amplitude rho_max
/// @param wall_points number of quadrature points on the wall
template <class Coordinates>
half_plane::ClosureEquations closure_equations(
    const problem::Problem& problem, const Coordinates& coordinates, double rho_max,
    const half_plane::ExponentConfinementTerm& confinement, half_plane::OrthonormalBasis basis,
    half_plane::QuadraturePoints points, int wall_points) {
  using Eigen::MatrixXd;
  using Eigen::VectorXd;
  VectorXd w(points.size()), s_rate = VectorXd::Zero(points.size()), t_rate = s_rate;
  const bool has_atom = coordinates.relative_atom_probability() > 0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    w[i] = coordinates.sqrt_twice_potential(points.y[i]);
    if (has_atom && i + 1 == points.size()) break;  // the mass at rest does not move
    const CoordinateTimeDerivatives rate = coordinates.coordinate_time_derivatives(
        problem.system, points.y[i], points.s[i], points.t[i]);
    s_rate[i] = rate.s;
    t_rate[i] = rate.t;
  }
  const auto s_tables = basis.polynomials_in_s().polynomial_derivative_tables(points.s, 1);
  const auto t_tables = basis.polynomials_in_t().polynomial_derivative_tables(points.t, 1);
  const auto& basis_functions = basis.basis_functions();
  const MatrixXd values = products_of_basis_columns(basis_functions, s_tables[0], t_tables[0]);
  const MatrixXd after_impulse = means_after_impulse(
      problem.impulses.amplitude_law(), basis, w, points.v,
      [&](double at_w, double v) { return coordinates.coordinates_after_impulse(at_w, v); });

  const auto wall = numerics::gauss_legendre_rule(wall_points, 0, rho_max);
  const Eigen::Map<const VectorXd> speed(wall.points.data(), wall.size());
  const VectorXd rebound_speed = problem.system.restitution() * speed;
  const auto on_wall = [&](const VectorXd& rho, double theta) {
    return basis.basis_values(rho, rho.unaryExpr([&](double at) {
      return Coordinates::second_exponent_coordinate(at, theta);
    }));
  };
  const MatrixXd wall_basis_functions = on_wall(speed, -std::numbers::pi / 2);
  const auto directional_derivative = [&](const VectorXd& of_s, const VectorXd& of_t) -> MatrixXd {
    return products_of_basis_columns(basis_functions, of_s.asDiagonal() * s_tables[1],
                                     t_tables[0]) +
           products_of_basis_columns(basis_functions, s_tables[0], of_t.asDiagonal() * t_tables[1]);
  };
  const MatrixXd impulse_terms = problem.impulses.arrival_rate() * (after_impulse - values);
  const problem::ExcitationTimeDependence& time = problem.time;
  std::vector<half_plane::TimeDependentGeneratorTerm> time_dependent_terms;
  if (time.has_rate_factor()) {
    time_dependent_terms.push_back(
        {[time](double at) { return time.rate_factor(at) - 1; }, impulse_terms});
  }
  if (time.has_external_force()) {
    VectorXd s_derivative = VectorXd::Zero(points.size()), t_derivative = s_derivative;
    for (Eigen::Index i = 0; i < points.size() - has_atom; ++i) {
      const CoordinateTimeDerivatives derivative =
          coordinates.coordinate_derivatives_in_v(points.s[i], points.t[i]);
      s_derivative[i] = derivative.s;
      t_derivative[i] = derivative.t;
    }
    time_dependent_terms.push_back({[time](double at) { return time.external_force(at); },
                                    directional_derivative(s_derivative, t_derivative)});
  }
  half_plane::GalerkinQuadratureTables tables{
      .weight = points.weight,
      .basis_functions = half_plane::BasisValuesAtPoints(basis, points.s, points.t),
      .generator_terms = directional_derivative(s_rate, t_rate) + impulse_terms,
      .time_dependent_terms = std::move(time_dependent_terms),
      .confinement_terms = points.energy.unaryExpr(confinement),
      .wall_weight = wall.weights.cwiseProduct(
          speed.unaryExpr([](double rho) { return Coordinates::density_prefactor(rho); })),
      .wall_basis_functions = wall_basis_functions,
      .impact_terms = speed.asDiagonal() *
                      (on_wall(rebound_speed, std::numbers::pi / 2) - wall_basis_functions),
      .wall_confinement_terms =
          speed.unaryExpr([&](double rho) { return confinement(energy_of_amplitude(rho)); })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

}  // namespace fpkcheck::epc::amplitude
