#pragma once

#include <cmath>

#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::contact {

/// Whether the mass can rest in contact with one wall on the left, towards which the force acts
/// everywhere. rho(y, v) is then increasing in y.
bool is_pressed_on_one_wall(const problem::Problem& problem);

/// Amplitude and velocity on the half-plane y >= 0 with the corner (0, 0), where the mass rests,
///
///     rho = sqrt(v^2 + 2 V(y)),   V(y) = U(y) - U(0),   |v| <= rho.
///
/// The density is
///
///     p(y, v) = C exp(Q_n(rho, v) + confinement) / e,   e = rho^2/2 the energy above the corner,
///
/// with an atom of probability P0 at the corner. At small energies the mass bounces under the
/// constant force g(0). The probability flux J towards the corner is the same at every energy, and
/// equals the rate lambda P0 at which impulses release the mass. Therefore
/// u^2 p(0, -u) -> J / ln(1/r), and
///
///     P0 = 2 C exp(Q_n(0, 0)) ln(1/r) / lambda.
///
/// (The exact limit has a small log-periodic dependence on u, which no polynomial has.) Functions
/// of rho and v have a value at the corner; functions of amplitude and phase do not. Polynomials of
/// y and v lack the odd powers of rho, among them the time until rest.
class Coordinates {
 public:
  /// @pre is_pressed_on_one_wall(problem); the wall at 0
  explicit Coordinates(const problem::Problem& problem);

  double w(double y) const { return std::sqrt(2 * potential_(y)); }
  /// Inverse of w: y from w(y).
  double y(double w) const;
  double rho(double y, double v) const { return std::hypot(w(y), v); }
  double force(double y) const { return force_(y); }

  /// 1/e at an amplitude rho > 0. The corner has the atom instead.
  static double prefactor(double rho) { return 2 / (rho * rho); }
  /// P0 / (C exp(Q_n(0, 0))).
  double atom_weight() const { return atom_weight_; }

 private:
  numerics::Polynomial potential_, force_;
  double atom_weight_;
};

/// Gauss-Legendre points in rho and theta, v = rho sin(theta). The coordinates s and t of the
/// points are rho and v. The weights include the factor 1/e of the density. The last point is the
/// atom.
/// @param size s: number of points in rho; t: in theta
half_plane::QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                               const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::contact
