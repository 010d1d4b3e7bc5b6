#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "epc/amplitude/amplitude_equations.hpp"
#include "epc/form/closed_form_parameters.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {

/// Coordinates amplitude rho and phase theta on the half-plane y >= 0,
///
///     rho cos(theta) = w(y) = sqrt(2 V(y)),   rho sin(theta) = v,   -pi/2 <= theta <= pi/2,
///     V(y) = U(y) + (K - k) y^2/2,            h = rho^2/2 = v^2/2 + V(y).
///
/// Along undamped free motion the amplitude rho is constant and the phase theta decreases. An
/// impact changes the phase theta from -pi/2 to pi/2 and multiplies the amplitude rho by the
/// restitution coefficient r. The stationary density p(y, v) has a jump at y = v = 0: p(0,0+) r^2 =
/// p(0,0-), with the restitution coefficient r. Functions of the phase theta can represent the jump
/// of the density at y = v = 0, unlike continuous functions of y and v.
///
/// The stiffness K of the potential V equals the stiffness k = g'(0) of the oscillator, and h is
/// the energy, except for small k. For small k, the stiffness K is a fraction of the stiffness of
/// equivalent linearisation, since with K = k the function sqrt(2 V(y)) would be nearly a power of
/// y above the first. The potential V does not include the mean of the impulses.
class AmplitudePhaseCoordinates {
 public:
  static constexpr ExponentCoordinates kVariables = ExponentCoordinates::polar;

  explicit AmplitudePhaseCoordinates(const problem::Problem& problem);

  /// Returns the speed w(y) = sqrt(2 V(y)), at which the kinetic energy equals the potential V(y).
  double sqrt_twice_potential(double y) const { return y * sqrt_twice_potential_over_y(y); }
  double sqrt_twice_potential_slope(double y) const {
    return potential_slope_ratio_(y) / sqrt_twice_potential_over_y(y);
  }
  /// Returns the displacement y at which sqrt(2 V(y)), with the potential V, has the value w.
  double displacement(double w) const;
  double displacement_slope(double y) const { return 1 / sqrt_twice_potential_slope(y); }
  double amplitude_of(double y, double v) const { return std::hypot(sqrt_twice_potential(y), v); }
  double phase_of(double y, double v) const { return std::atan2(v, sqrt_twice_potential(y)); }
  std::pair<double, double> coordinates_of_state(double y, double v) const {
    return {amplitude_of(y, v), phase_of(y, v)};
  }
  /// Returns the amplitude and the phase after an impulse that changes the velocity to v, at the
  /// displacement y with sqrt(2 V(y)) = w.
  static std::pair<double, double> coordinates_after_impulse(double w, double v) {
    return {std::sqrt(w * w + v * v), std::atan2(v, w)};
  }
  static double second_exponent_coordinate(double, double theta) { return theta; }
  static double phase(double, double theta) { return theta; }
  /// Returns the ratio g(y) / sqrt(2 V(y)) with the restoring force g and the potential V.
  double force_over_sqrt_twice_potential(double y) const {
    return force_ratio_(y) / sqrt_twice_potential_over_y(y);
  }

  /// Returns the rates of change of amplitude rho and phase theta between impulses,
  ///
  ///     rho'   = -c rho sin^2 + (w w' - g) sin,
  ///     theta' = -w' sin^2 - (g/w) cos^2 - c sin cos,      sin, cos of theta.
  amplitude::CoordinateTimeDerivatives coordinate_time_derivatives(const problem::System& system,
                                                                   double y, double rho,
                                                                   double theta) const;
  /// Returns the derivatives of the amplitude rho and of the phase theta with respect to the
  /// velocity v: sin(theta) and cos(theta) / rho.
  static amplitude::CoordinateTimeDerivatives coordinate_derivatives_in_v(double rho,
                                                                          double theta) {
    return {std::sin(theta), std::cos(theta) / rho};
  }
  static double density_prefactor(double) { return 1; }
  static double relative_atom_probability() { return 0; }
  /// Returns the amplitudes below rho_max from which an impulse may stop the mass at the wall.
  /// Impulses of a law with atoms may stop the mass at the wall, and the mean of a basis function
  /// over the impulses has a jump at the amplitude of such a stop.
  static std::vector<double> amplitude_break_points(const problem::ImpulseLaw& law, double rho_max);
  /// Returns one phase, since the coefficient of the highest power of the amplitude rho does not
  /// depend on the phase theta.
  static std::vector<double> phases_for_leading_form_sign() { return {0}; }

 private:
  double sqrt_twice_potential_over_y(double y) const { return std::sqrt(potential_ratio_(y)); }
  double displacement_upper_bound(double w) const;

  numerics::Polynomial potential_ratio_;        // polynomial 2 V(y) / y^2
  numerics::Polynomial potential_slope_ratio_;  // polynomial V'(y) / y
  numerics::Polynomial force_ratio_;            // polynomial g(y) / y
};

}  // namespace fpkcheck::epc::polar
