#pragma once

#include <cmath>
#include <vector>

#include "epc/half_plane/points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::polar {

/// Amplitude and phase of the half-plane y >= 0,
///
///     rho cos(theta) = w(y) = sqrt(2 V(y)),   rho sin(theta) = v,   -pi/2 <= theta <= pi/2,
///     V(y) = U(y) + (K - k) y^2/2,            h = rho^2/2 = v^2/2 + V(y).
///
/// The oscillator without damping keeps rho and turns clockwise; an impact takes it from
/// theta = -pi/2 to pi/2 and multiplies rho by r. The density jumps at the origin,
/// p(0,0+) r^2 = p(0,0-), and fans out from there: functions of theta do so too, those of y and v
/// cannot.
///
/// K is the stiffness k = g'(0), so that h is the energy; only where k is so small that w(y) would
/// be nearly a higher power of y, K is a part of the linearised stiffness. The mean of the impulses
/// is no part of V.
class Coordinates {
 public:
  explicit Coordinates(const problem::Problem& problem);

  double w(double y) const { return y * root_of_share(y); }
  /// dw/dy > 0
  double slope(double y) const { return pull_(y) / root_of_share(y); }
  /// y of w(y), the inverse.
  double y(double w) const;
  double rho(double y, double v) const { return std::hypot(w(y), v); }
  double theta(double y, double v) const { return std::atan2(v, w(y)); }
  /// g(y) / w(y): the slope of w where K = k.
  double force_by_w(double y) const { return force_(y) / root_of_share(y); }

 private:
  /// w(y) / y
  double root_of_share(double y) const { return std::sqrt(share_(y)); }
  /// At least y(w), and not far from it.
  double bound(double w) const;

  numerics::Polynomial share_;  // 2 V(y) / y^2
  numerics::Polynomial pull_;   // V'(y) / y
  numerics::Polynomial force_;  // g(y) / y
};

/// Gauss-Legendre in rho and theta, the coordinates s and t of the points: what fans out from the
/// origin is smooth in them.
/// @param breaks increasing amplitudes between 0 and rho_max at which the integrand may change
///   abruptly on the wall; panels end there
/// @param size s: the points in rho; between one break and the next as many more as to keep its
///   ends resolved
half_plane::Points rule(const Coordinates& coordinates, double rho_max,
                        const std::vector<double>& breaks, const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::polar
