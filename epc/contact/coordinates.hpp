#pragma once

#include <cmath>

#include "epc/half_plane/points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::contact {

/// Whether the mass rests in contact with one wall on the left, against which the force presses it
/// from everywhere: rho(y, v) is then increasing in y.
bool applies(const problem::Problem& problem);

/// Amplitude and velocity of the half-plane y >= 0 above the corner (0, 0), where the mass rests,
///
///     rho = sqrt(v^2 + 2 V(y)),   V(y) = U(y) - U(0),   |v| <= rho.
///
/// The density is
///
///     p(y, v) = C exp(Q_n(rho, v) + confinement) / e,   e = rho^2/2 the energy above the corner,
///
/// and what comes to rest is an atom there: below a small energy the motion is a bouncing under the
/// constant force g(0), which loses as many a unit of time at each energy, J = lambda P0 as many as
/// impulses free. So u^2 p(0, -u) -> J / ln(1/r), and with the density above
///
///     P0 = 2 C exp(Q_n(0, 0)) ln(1/r) / lambda.
///
/// (In truth it is log-periodic in u by a little, which no polynomial has.) Functions of rho and v
/// have a value at the corner, as those of amplitude and phase have not; odd powers of rho are what
/// polynomials of y and v lack there, the time until rest among them.
class Coordinates {
 public:
  /// @pre applies(problem); the wall at 0
  explicit Coordinates(const problem::Problem& problem);

  double w(double y) const { return std::sqrt(2 * potential_(y)); }
  /// y of w(y), the inverse.
  double y(double w) const;
  double rho(double y, double v) const { return std::hypot(w(y), v); }
  double force(double y) const { return force_(y); }

  /// 1/e at an amplitude; at the corner, where the atom is, it has none.
  static double prefactor(double rho) { return 2 / (rho * rho); }
  /// P0 by C exp(Q_n(0, 0)).
  double atom_weight() const { return atom_weight_; }

 private:
  numerics::Polynomial potential_, force_;
  double atom_weight_;
};

/// Gauss-Legendre in rho and theta, v = rho sin(theta); rho and v are the coordinates s and t of
/// the points. The weights have the factor 1/e of the density in them, and the last point is the
/// atom.
/// @param size s: the points in rho
half_plane::Points rule(const Coordinates& coordinates, double rho_max,
                        const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::contact
