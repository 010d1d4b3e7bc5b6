#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "epc/amplitude/amplitude_equations.hpp"
#include "epc/form/closed_form_parameters.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {

/// Returns whether the oscillator has only a left wall, the mass can rest in contact with this
/// wall, and the restoring force acts towards this wall everywhere.
bool spring_presses_on_single_wall(const problem::Problem& problem);

/// Coordinates amplitude rho and velocity v on y >= 0, with the potential V(y) = U(y) - U(0):
///
///     rho = sqrt(v^2 + 2 V(y)),   |v| <= rho.
///
/// The density of a closure with the energy e = rho^2/2 is
///
///     p(y, v) = C exp(Q_n(rho, v) + confinement) / e,
///
/// plus an atom of probability P0 at the corner y = v = 0, where the mass rests in contact. At
/// small energies the restoring force is nearly constant, and the mass bounces on the wall. At
/// small energies the probability flux J towards the corner y = v = 0 does not depend on the
/// energy. The probability flux J towards rest equals the rate lambda P0 at which impulses of rate
/// lambda release the mass. Therefore u^2 p(0, -u) -> J / ln(1/r) for u -> 0, and
///
///     P0 = 2 C exp(Q_n(0, 0)) ln(1/r) / lambda.
///
/// The exact density near y = v = 0 has a small log-periodic dependence on the impact speed u,
/// which no polynomial can represent. Continuous functions of the amplitude rho and the velocity v
/// have a unique value at the corner y = v = 0, unlike functions of amplitude and phase.
/// Polynomials of y and v cannot represent odd powers of the amplitude rho = sqrt(v^2 + 2 V(y)).
/// The time until the mass comes to rest is an odd power of the amplitude rho.
class AmplitudeVelocityCoordinates {
 public:
  static constexpr ExponentCoordinates kVariables = ExponentCoordinates::contact;

  /// @pre spring_presses_on_single_wall(problem), and the wall is at y = 0
  explicit AmplitudeVelocityCoordinates(const problem::Problem& problem);

  /// Returns the speed w(y) = sqrt(2 V(y)), at which the kinetic energy equals the potential V(y).
  double sqrt_twice_potential(double y) const { return std::sqrt(2 * potential_(y)); }
  /// Returns the displacement y at which sqrt(2 V(y)), with the potential V, has the value w.
  double displacement(double w) const;
  /// Returns the derivative dy/dw = w/g of the displacement y with respect to w = sqrt(2 V(y)),
  /// where g is the restoring force.
  double displacement_slope(double y) const { return sqrt_twice_potential(y) / force_(y); }
  double amplitude_of(double y, double v) const { return std::hypot(sqrt_twice_potential(y), v); }
  std::pair<double, double> coordinates_of_state(double y, double v) const {
    return {amplitude_of(y, v), v};
  }
  /// Returns the amplitude rho and the velocity after an impulse that changes the velocity to v, at
  /// the displacement y with sqrt(2 V(y)) = w. If the mass rests in contact with the wall, each
  /// impulse towards the wall causes an impact at once.
  std::pair<double, double> coordinates_after_impulse(double w, double v) const {
    if (w == 0 && v < 0) return {-restitution_ * v, -restitution_ * v};
    return {std::hypot(w, v), v};
  }
  static double second_exponent_coordinate(double rho, double theta) {
    return rho * std::sin(theta);
  }
  static double phase(double rho, double v) {
    return rho > 0 ? std::asin(std::clamp(v / rho, -1.0, 1.0)) : 0;
  }
  /// Returns the rates of change of amplitude and velocity between impulses: rho' = -v f / rho and
  /// v' = -(f + g), with the damping force f and the restoring force g.
  amplitude::CoordinateTimeDerivatives coordinate_time_derivatives(const problem::System& system,
                                                                   double y, double rho,
                                                                   double v) const;
  /// Returns the derivatives of the amplitude rho and of the velocity v in v: v / rho and 1.
  static amplitude::CoordinateTimeDerivatives coordinate_derivatives_in_v(double rho, double v) {
    return {v / rho, 1};
  }

  /// Returns the factor 1/e of the density at an amplitude rho > 0, with the energy e = rho^2/2.
  static double density_prefactor(double rho) { return 2 / (rho * rho); }
  /// Returns the probability P0 of the atom at rest divided by C exp(Q_n(0, 0)).
  double relative_atom_probability() const { return atom_weight_; }
  /// Returns an empty list, since the mean of a basis function over the impulses has no jump.
  static std::vector<double> amplitude_break_points(const problem::ImpulseLaw&, double) {
    return {};
  }
  static std::vector<double> phases_for_leading_form_sign() {
    return {amplitude::equidistant_phases().begin(), amplitude::equidistant_phases().end()};
  }

 private:
  numerics::Polynomial potential_, force_;
  double restitution_, atom_weight_;
};

}  // namespace fpkcheck::epc::contact
