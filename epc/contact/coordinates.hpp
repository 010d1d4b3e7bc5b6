#pragma once

#include <cmath>

#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::contact {

/// Whether the problem has one wall on the left, with which the mass can rest in contact, and the
/// restoring force acts towards this wall everywhere. Then rho(y, v) increases with y.
bool is_pressed_on_one_wall(const problem::Problem& problem);

/// Coordinates amplitude and velocity on the half-plane y >= 0. In the corner (0, 0) the mass rests
/// in contact with the wall.
///
///     rho = sqrt(v^2 + 2 V(y)),   V(y) = U(y) - U(0),   |v| <= rho.
///
/// The density is
///
///     p(y, v) = C exp(Q_n(rho, v) + confinement) / e,   e = rho^2/2 the energy above the corner,
///
/// with an atom of probability P0 at the corner. At small energies the force is the constant g(0),
/// and the mass bounces on the wall. The probability flux J towards the corner is the same at every
/// small energy, and equals the rate lambda P0 at which impulses release the mass. Therefore
/// u^2 p(0, -u) -> J / ln(1/r), and
///
///     P0 = 2 C exp(Q_n(0, 0)) ln(1/r) / lambda.
///
/// (The exact limit has a small log-periodic dependence on u, which no polynomial can represent.)
/// Continuous functions of rho and v have a value at the corner; functions of amplitude and phase
/// have none. Polynomials of y and v do not contain the odd powers of rho. The time until the mass
/// comes to rest is such an odd power.
class Coordinates {
 public:
  /// @pre is_pressed_on_one_wall(problem); the wall at 0
  explicit Coordinates(const problem::Problem& problem);

  /// Speed w(y) = sqrt(2 V(y)), at which the kinetic energy equals the potential energy V(y).
  double potential_speed(double y) const { return std::sqrt(2 * potential_(y)); }
  /// Displacement y from w(y): the inverse function of w.
  double displacement(double w) const;
  /// Amplitude rho of a state.
  double amplitude_of(double y, double v) const { return std::hypot(potential_speed(y), v); }
  /// Restoring force g(y).
  double restoring_force(double y) const { return force_(y); }

  /// Factor 1/e of the density at an amplitude rho > 0. In the corner, an atom replaces the
  /// density.
  static double density_prefactor(double rho) { return 2 / (rho * rho); }
  /// Ratio of the probability of the atom to the exponential: P0 / (C exp(Q_n(0, 0))).
  double atom_weight() const { return atom_weight_; }

 private:
  numerics::Polynomial potential_, force_;
  double atom_weight_;
};

/// Gauss-Legendre points in amplitude rho and phase theta, v = rho sin(theta). The coordinates s
/// and t of the points are rho and v. The weights include the factor 1/e of the density. The last
/// point is the atom.
/// @param size numbers of points: s in rho, t in theta
half_plane::QuadraturePoints quadrature_points(const Coordinates& coordinates, double rho_max,
                                               const half_plane::QuadratureSize& size);

}  // namespace fpkcheck::epc::contact
