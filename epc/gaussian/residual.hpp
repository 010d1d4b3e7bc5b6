#pragma once

#include <array>

#include "numerics/polynomials/polynomial.hpp"
#include "problem/model.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// lambda E[Y^j], j = 0 .. 4; entry 0 is not used.
using RateMoments = std::array<double, 5>;

/// Coefficients of the residual F, paper (22). The spring force on the (z, z') plane is the odd
/// continuation sgn(x1) g(|x1|): odd powers of g unchanged, even powers times sgn(x1).
struct ResidualCoefficients {
  double damping;                   ///< c
  numerics::Polynomial odd_force;   ///< odd powers of g
  numerics::Polynomial even_force;  ///< even powers of g
  double impact_loss;               ///< 1 - r
  RateMoments rate_moment;
  /// Factor of JumpRemainder: the jump integral
  /// lambda ( E[exp(Q(x1, x2 - sgn(x1) Y) - Q)] - 1 ) minus its Kramers-Moyal series up to the
  /// fourth derivative. 1 for `kf`, else 0.
  double jump_fraction;
  /// True: Zhuravlev's plane (z, z'), folded at a wall. False: the plane (y, y') without a wall,
  /// with all of g in odd_force, even_force 0, the damping f = y' (damping_polynomial(y) + rayleigh
  /// y'^2), and F = unfolded_part().
  bool folded = true;
  numerics::Polynomial damping_polynomial{{}};
  double rayleigh = 0;
};

/// Coefficients of F for a problem.
/// @param equation white (without E[Y^3] and E[Y^4]), km4 or kf
ResidualCoefficients residual_coefficients(const problem::Problem& problem,
                                           problem::Equation equation);

/// Coefficients on a linear homotopy from white noise with elastic impacts (fraction 0) to the full
/// problem (fraction 1): 1-r, lambda E[Y], E[Y^3], E[Y^4] and jump_fraction are multiplied by the
/// fraction. At fraction 0 the density is C exp( -(c/D2)(x2^2/2 + U(|x1|)) ).
ResidualCoefficients homotopy_coefficients(const ResidualCoefficients& full, double fraction);

/// Derivatives of Q_n at a point; q22 is the second derivative in x2, and so on.
struct Derivatives {
  double q1, q2, q22, q222, q2222;
};

// F of paper (22) is split by the factors of its terms,
//
//     F = smooth + sgn(x1) signed + delta(x1) |x2| impact,
//
// since each factor has its own quadrature rule. Each part has a gradient with respect to the
// derivatives of Q_n. g = g_odd + g_even is the spring force.

/// -x2 Q_1 + [c x2 + g_odd(x1)] Q_2 + lambda E[Y^2]/2! [Q_22 + Q_2^2]
/// + lambda E[Y^4]/4! [Q_2222 + 4 Q_2 Q_222 + 3 Q_22^2 + 6 Q_2^2 Q_22 + Q_2^4] + c
double smooth_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q);
Derivatives smooth_gradient(const ResidualCoefficients& f, double x1, double x2,
                            const Derivatives& q);

/// [g_even(x1) - lambda E[Y]] Q_2 - lambda E[Y^3]/3! [Q_222 + 3 Q_2 Q_22 + Q_2^3]
double signed_part(const ResidualCoefficients& f, double x1, const Derivatives& q);
Derivatives signed_gradient(const ResidualCoefficients& f, double x1, const Derivatives& q);

/// F without a wall, for any damping f: smooth and signed parts without the sign,
/// -x2 Q_1 + [f + g - lambda E[Y]] Q_2 + f_v + (lambda E[Y^2] + 2D)/2! [Q_22 + Q_2^2] - ..
double unfolded_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q);
Derivatives unfolded_gradient(const ResidualCoefficients& f, double x1, double x2,
                              const Derivatives& q);

/// Impulse terms of smooth and signed part, that is, the truncated Kramers-Moyal series times
/// exp(-Q).
/// @param side 1 for x1 > 0, -1 for x1 < 0
double series_part(const RateMoments& rate_moment, int side, const Derivatives& q);
Derivatives series_gradient(const RateMoments& rate_moment, int side, const Derivatives& q);

/// (1-r) [x2 Q_2 + 2]
double impact_part(const ResidualCoefficients& f, double x2, const Derivatives& q);
Derivatives impact_gradient(const ResidualCoefficients& f, double x2);

}  // namespace fpkcheck::epc::gaussian
