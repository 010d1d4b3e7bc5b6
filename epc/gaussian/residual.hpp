#pragma once

#include <array>

#include "numerics/polynomials/polynomial.hpp"
#include "problem/model.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Products lambda E[Y^j] of the rate and the moments of the impulses, j = 0 .. 4; entry 0 is
/// unused.
using RateTimesMoments = std::array<double, 5>;

/// Coefficients of the residual F of paper (22). The spring force on the (z, z') plane is the odd
/// continuation sgn(x1) g(|x1|): odd powers of g are unchanged, and even powers are multiplied by
/// sgn(x1).
struct ResidualCoefficients {
  double damping;                   ///< damping coefficient c
  numerics::Polynomial odd_force;   ///< odd powers of the spring force g
  numerics::Polynomial even_force;  ///< even powers of the spring force g
  double impact_loss;               ///< 1 - r, r the restitution coefficient
  RateTimesMoments rate_times_moment;
  /// Factor of JumpIntegralRemainder, which is the jump integral
  /// lambda ( E[exp(Q(x1, x2 - sgn(x1) Y) - Q)] - 1 ) minus the Kramers-Moyal series of this
  /// integral up to the fourth derivative. The factor is 1 for `kf`, else 0.
  double jump_fraction;
  /// Whether the plane is Zhuravlev's plane (z, z'), which is folded at the wall. Otherwise the
  /// plane is (y, y'), and there is no wall: odd_force is the whole force g, even_force is 0, the
  /// damping force is f = y' (damping_polynomial(y) + rayleigh y'^2), and F = unfolded_residual().
  bool folded = true;
  numerics::Polynomial damping_polynomial{{}};
  double rayleigh = 0;
};

/// Coefficients of the residual F for a problem.
/// @param equation equation to solve: white (without E[Y^3] and E[Y^4]), km4 or kf
ResidualCoefficients residual_coefficients(const problem::Problem& problem,
                                           problem::Equation equation);

/// Coefficients on a linear homotopy from white noise with elastic impacts (fraction 0) to the full
/// problem (fraction 1): 1-r, lambda E[Y], E[Y^3], E[Y^4] and jump_fraction are multiplied by the
/// fraction. At fraction 0 the density is C exp( -(c/D2)(x2^2/2 + U(|x1|)) ).
ResidualCoefficients homotopy_coefficients(const ResidualCoefficients& full, double fraction);

/// The derivatives of Q_n at a point: q1 is the first derivative in x1, and q22 the second
/// derivative in x2.
struct ExponentDerivatives {
  double q1, q2, q22, q222, q2222;
};

// F of paper (22) is split by the factors of its terms,
//
//     F = smooth + sgn(x1) signed + delta(x1) |x2| impact,
//
// since each factor has its own quadrature rule. Each part has a gradient with respect to the
// derivatives of Q_n. g = g_odd + g_even is the spring force.

/// Part of F without a discontinuous factor,
/// -x2 Q_1 + [c x2 + g_odd(x1)] Q_2 + lambda E[Y^2]/2! [Q_22 + Q_2^2]
/// + lambda E[Y^4]/4! [Q_2222 + 4 Q_2 Q_222 + 3 Q_22^2 + 6 Q_2^2 Q_22 + Q_2^4] + c
double smooth_residual_part(const ResidualCoefficients& f, double x1, double x2,
                            const ExponentDerivatives& q);
ExponentDerivatives smooth_residual_gradient(const ResidualCoefficients& f, double x1, double x2,
                                             const ExponentDerivatives& q);

/// Part of F with the factor sgn(x1),
/// [g_even(x1) - lambda E[Y]] Q_2 - lambda E[Y^3]/3! [Q_222 + 3 Q_2 Q_22 + Q_2^3]
double signed_residual_part(const ResidualCoefficients& f, double x1, const ExponentDerivatives& q);
ExponentDerivatives signed_residual_gradient(const ResidualCoefficients& f, double x1,
                                             const ExponentDerivatives& q);

/// The residual F without a wall, for any damping force f. F is the sum of the smooth part and the
/// signed part, the latter without the factor sgn(x1):
/// -x2 Q_1 + [f + g - lambda E[Y]] Q_2 + f_v + (lambda E[Y^2] + 2D)/2! [Q_22 + Q_2^2] - ..
double unfolded_residual(const ResidualCoefficients& f, double x1, double x2,
                         const ExponentDerivatives& q);
ExponentDerivatives unfolded_residual_gradient(const ResidualCoefficients& f, double x1, double x2,
                                               const ExponentDerivatives& q);

/// Terms of the impulses in the smooth and the signed part of F: the truncated Kramers-Moyal series
/// applied to exp(Q), divided by exp(Q).
/// @param side 1 for x1 > 0, -1 for x1 < 0
double series_residual_part(const RateTimesMoments& rate_times_moment, int side,
                            const ExponentDerivatives& q);
ExponentDerivatives series_residual_gradient(const RateTimesMoments& rate_times_moment, int side,
                                             const ExponentDerivatives& q);

/// Part of F with the factor delta(x1) |x2|, from the impacts: (1-r) [x2 Q_2 + 2]
double impact_residual_part(const ResidualCoefficients& f, double x2, const ExponentDerivatives& q);
ExponentDerivatives impact_residual_gradient(const ResidualCoefficients& f, double x2);

}  // namespace fpkcheck::epc::gaussian
