#pragma once

#include <cmath>
#include <vector>

#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

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
/// K is the stiffness k = g'(0); then h is the energy. For small k, w(y) would nearly be a higher
/// power of y, and K is a fraction of the stiffness of equivalent linearisation instead. The
/// potential V does not include the mean of the impulses.
class Coordinates {
 public:
  explicit Coordinates(const problem::Problem& problem);

  /// Speed w(y) = sqrt(2 V(y)), at which the kinetic energy equals the potential energy V(y).
  double potential_speed(double y) const { return y * potential_speed_over_y(y); }
  /// Derivative dw/dy > 0.
  double potential_speed_slope(double y) const {
    return potential_slope_ratio_(y) / potential_speed_over_y(y);
  }
  /// Displacement y from w(y): the inverse function of w.
  double displacement(double w) const;
  /// Amplitude rho of a state.
  double amplitude_of(double y, double v) const { return std::hypot(potential_speed(y), v); }
  /// Phase theta of a state.
  double phase_of(double y, double v) const { return std::atan2(v, potential_speed(y)); }
  /// Ratio g(y) / w(y), which equals dw/dy if K = k.
  double force_over_potential_speed(double y) const {
    return force_ratio_(y) / potential_speed_over_y(y);
  }

 private:
  /// Ratio w(y) / y.
  double potential_speed_over_y(double y) const { return std::sqrt(potential_ratio_(y)); }
  /// Upper bound, close to y(w), of the displacement y(w).
  double displacement_bound(double w) const;

  numerics::Polynomial potential_ratio_;        // 2 V(y) / y^2
  numerics::Polynomial potential_slope_ratio_;  // V'(y) / y
  numerics::Polynomial force_ratio_;            // g(y) / y
};

/// Gauss-Legendre points in rho and theta, which are the coordinates s and t of the points. The
/// jump of the density at the origin is a smooth function of these coordinates.
/// @param breaks increasing amplitudes between 0 and rho_max at which the integrand may change
///   abruptly on the wall; a panel in rho ends at each of these amplitudes
/// @param size numbers of points: s in rho, with additional points near the breaks, t in theta
half_plane::QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                               const std::vector<double>& breaks,
                                               const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::polar
