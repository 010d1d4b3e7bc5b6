#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "epc/amplitude/coordinate_policy.hpp"
#include "epc/form/closed_form.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {

/// Coordinates amplitude and phase on the half-plane y >= 0,
///
///     rho cos(theta) = w(y) = sqrt(2 V(y)),   rho sin(theta) = v,   -pi/2 <= theta <= pi/2,
///     V(y) = U(y) + (K - k) y^2/2,            h = rho^2/2 = v^2/2 + V(y).
///
/// Along the motion of the undamped oscillator, rho is constant and theta decreases. An impact
/// changes theta from -pi/2 to pi/2 and multiplies rho by r. The density has a jump at the origin,
/// p(0,0+) r^2 = p(0,0-), which extends into the plane as a function of theta. Functions of theta
/// represent this jump; continuous functions of y and v do not.
///
/// K is the stiffness k = g'(0); then h is the energy. For small k, w(y) with K = k would nearly be
/// a higher power of y; K is then a fraction of the stiffness of equivalent linearisation. The
/// potential V does not include the mean of the impulses.
class Coordinates {
 public:
  static constexpr ExponentCoordinates kVariables = ExponentCoordinates::polar;

  explicit Coordinates(const problem::Problem& problem);

  /// Speed w(y) = sqrt(2 V(y)), at which the kinetic energy equals the potential energy V(y).
  double potential_speed(double y) const { return y * potential_speed_over_y(y); }
  /// Derivative dw/dy > 0.
  double potential_speed_slope(double y) const {
    return potential_slope_ratio_(y) / potential_speed_over_y(y);
  }
  /// Displacement y from w(y): the inverse function of w.
  double displacement(double w) const;
  /// Derivative dy/dw at a displacement y.
  double displacement_slope(double y) const { return 1 / potential_speed_slope(y); }
  /// Amplitude rho of a state.
  double amplitude_of(double y, double v) const { return std::hypot(potential_speed(y), v); }
  /// Phase theta of a state.
  double phase_of(double y, double v) const { return std::atan2(v, potential_speed(y)); }
  /// Coordinates rho and theta of a state.
  std::pair<double, double> coordinates_of_state(double y, double v) const {
    return {amplitude_of(y, v), phase_of(y, v)};
  }
  /// Coordinates rho and theta of the velocity v after an impulse, at the speed w(y).
  static std::pair<double, double> coordinates_after_impulse(double w, double v) {
    return {std::sqrt(w * w + v * v), std::atan2(v, w)};
  }
  static double second_coordinate(double, double theta) { return theta; }
  static double phase(double, double theta) { return theta; }
  /// Ratio g(y) / w(y), which equals dw/dy if K = k.
  double force_over_potential_speed(double y) const {
    return force_ratio_(y) / potential_speed_over_y(y);
  }

  /// Rates of change between impulses,
  ///
  ///     rho'   = -c rho sin^2 + (w w' - g) sin,
  ///     theta' = -w' sin^2 - (g/w) cos^2 - c sin cos,      sin, cos of theta.
  amplitude::FlowRates flow_rates(const problem::System& system, double y, double rho,
                                  double theta) const;
  static double density_prefactor(double) { return 1; }
  static double atom_weight() { return 0; }
  /// Amplitudes below rho_max from which an impulse, an atom of the law, may stop the mass at the
  /// wall. At these amplitudes the mean of phi over the impulses has the jump that phi has at the
  /// origin. The list is empty for a law without atoms.
  static std::vector<double> amplitude_break_points(const problem::ImpulseLaw& law, double rho_max);
  /// The coefficient of the highest power of rho does not depend on theta: Q_n falls either at
  /// every phase or at no phase.
  static std::vector<double> leading_phases() { return {0}; }

 private:
  /// Ratio w(y) / y.
  double potential_speed_over_y(double y) const { return std::sqrt(potential_ratio_(y)); }
  /// Upper bound, close to y(w), of the displacement y(w).
  double displacement_bound(double w) const;

  numerics::Polynomial potential_ratio_;        // 2 V(y) / y^2
  numerics::Polynomial potential_slope_ratio_;  // V'(y) / y
  numerics::Polynomial force_ratio_;            // g(y) / y
};

}  // namespace fpkcheck::epc::polar
