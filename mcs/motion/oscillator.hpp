#pragma once

#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
class System;
}

namespace fpkcheck::mcs {

/// The oscillator of paper (1)-(2), with precomputed properties of its spring force g(y) that
/// flights use.
struct Oscillator {
  static constexpr int kHighestDegree = 5;

  /// @throws InputError if the energy does not bound the motion, or if g(0) is not 0; the step
  /// limit needs the energy bound and g(0) = 0
  explicit Oscillator(const problem::System& system);
  /// @param spring spring force g(y), a polynomial of degree 1 .. kHighestDegree
  Oscillator(double c, double r, const numerics::Polynomial& spring);

  double damping;      ///< c
  double restitution;  ///< r
  numerics::Polynomial force, potential;
  int degree;  ///< degree of the force

  /// Whether g(y) = k y + mu y^3, the paper's spring, which has closed formulas.
  bool is_duffing;
  double stiffness, cubic;  ///< k, mu

  /// sum_n n |g_n| y^(n-1), an upper bound of the tangent and secant slopes of g between 0 and y.
  numerics::Polynomial slope_bound;
  /// Coefficient of a lower bound: U(y) >= potential_bound y^(degree + 1). An energy E therefore
  /// bounds the displacement, y <= (E / potential_bound)^(1/(degree + 1)).
  double potential_bound;
};

}  // namespace fpkcheck::mcs
