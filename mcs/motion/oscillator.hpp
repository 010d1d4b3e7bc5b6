#pragma once

#include "numerics/polynomials/polynomial.hpp"

namespace fpkcheck::problem {
class System;
}

namespace fpkcheck::mcs {

/// The oscillator of paper (1)-(2) as the flights take it, with what they need of its spring g(y)
/// made once.
struct Oscillator {
  static constexpr int kHighestDegree = 5;

  /// @throws InputError when no energy bounds the motion, or g(0) is not 0: the length of the
  ///         flights rests on both
  explicit Oscillator(const problem::System& system);
  /// @param spring g, of degree 1 .. kHighestDegree
  Oscillator(double c, double r, const numerics::Polynomial& spring);

  double damping;      ///< c
  double restitution;  ///< r
  numerics::Polynomial force, potential;
  int degree;  ///< of the force

  /// g(y) = k y + mu y^3, the paper's spring: it has formulas of its own.
  bool is_duffing;
  double stiffness, cubic;  ///< k, mu

  /// sum_n n |g_n| y^(n-1): no tangent and no secant of the spring is steeper, from 0 to y.
  numerics::Polynomial steepest;
  /// How far out an energy E reaches: y <= (E / least_potential)^(1/(degree + 1)), as
  /// U(y) >= least_potential y^(degree + 1).
  double least_potential;
};

}  // namespace fpkcheck::mcs
