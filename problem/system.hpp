#pragma once

#include "parameters/description.hpp"
#include "problem/polynomial.hpp"

namespace fpkcheck::problem {

/// Coefficients of the oscillator, as read from a case file. All quantities are non-dimensional,
/// here and everywhere in the project.
struct SystemCoefficients {
  double damping;      ///< c > 0
  double stiffness;    ///< k >= 0, and k > 0 when mu = 0
  double cubic;        ///< mu >= 0
  double restitution;  ///< r, 0 < r <= 1
};

/// The coefficients as case files, tables and files name them.
const parameters::Description<SystemCoefficients>& system_description();

/// The vibro-impact Duffing oscillator, paper (1)-(2):
///
///     y'' + c y' + g(y) = xi(t)  for y > 0,      y'(+) = -r y'(-)  at y = 0,
///     g(y) = k y + mu y^3.
///
/// The spring is stated here and nowhere else: whoever needs the force, its slope or its potential
/// takes these polynomials, which hold for y >= 0. (On the (z, z') plane of paper (5) the force at
/// z < 0 is -g(-z).)
class System {
 public:
  /// @throws InputError naming the coefficient, its value and the allowed range
  explicit System(const SystemCoefficients& coefficients);

  const SystemCoefficients& coefficients() const { return c_; }
  double damping() const { return c_.damping; }
  double restitution() const { return c_.restitution; }

  /// g(y), the restoring force.
  const Polynomial& force() const { return force_; }
  /// g'(y), the tangent stiffness.
  const Polynomial& tangent_stiffness() const { return tangent_; }
  /// U(y), the integral of g from 0.
  const Polynomial& potential() const { return potential_; }
  /// True when g(y) = k y.
  bool linear() const { return force_.degree() == 1; }
  /// k = g'(0), the stiffness at the wall.
  double stiffness() const { return tangent_.coefficient(0); }

 private:
  SystemCoefficients c_;
  Polynomial force_, tangent_, potential_;
};

}  // namespace fpkcheck::problem
