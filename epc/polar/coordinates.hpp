#pragma once

#include <cmath>
#include <vector>

#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::polar {

/// Amplitude and phase on the half-plane y >= 0,
///
///     rho cos(theta) = w(y) = sqrt(2 V(y)),   rho sin(theta) = v,   -pi/2 <= theta <= pi/2,
///     V(y) = U(y) + (K - k) y^2/2,            h = rho^2/2 = v^2/2 + V(y).
///
/// The undamped oscillator keeps rho and decreases theta. An impact changes theta from -pi/2 to
/// pi/2 and multiplies rho by r. The density has a jump at the origin, p(0,0+) r^2 = p(0,0-), which
/// extends into the plane as a function of theta. Functions of theta represent this jump; functions
/// of y and v do not.
///
/// K is the stiffness k = g'(0), and h is then the energy. For small k, where w(y) would nearly be
/// a higher power of y, K is a fraction of the linearised stiffness. V excludes the mean of the
/// impulses.
class Coordinates {
 public:
  explicit Coordinates(const problem::Problem& problem);

  double w(double y) const { return y * w_over_y(y); }
  /// dw/dy > 0
  double slope(double y) const { return potential_slope_ratio_(y) / w_over_y(y); }
  /// Inverse of w: y from w(y).
  double y(double w) const;
  double rho(double y, double v) const { return std::hypot(w(y), v); }
  double theta(double y, double v) const { return std::atan2(v, w(y)); }
  /// g(y) / w(y), which equals dw/dy if K = k.
  double force_over_w(double y) const { return force_ratio_(y) / w_over_y(y); }

 private:
  /// w(y) / y
  double w_over_y(double y) const { return std::sqrt(potential_ratio_(y)); }
  /// Upper estimate of y(w), close to y(w).
  double displacement_bound(double w) const;

  numerics::Polynomial potential_ratio_;        // 2 V(y) / y^2
  numerics::Polynomial potential_slope_ratio_;  // V'(y) / y
  numerics::Polynomial force_ratio_;            // g(y) / y
};

/// Gauss-Legendre points in rho and theta, the coordinates s and t of the points. A jump at the
/// origin that extends into the plane is smooth in them.
/// @param breaks increasing amplitudes between 0 and rho_max at which the integrand may change
///   abruptly on the wall; panels end there
/// @param size s: number of points in rho, with additional points at the breaks; t: in theta
half_plane::QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                               const std::vector<double>& breaks,
                                               const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::polar
