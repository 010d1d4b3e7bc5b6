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

/// Coefficients of the residual F, paper (22). The spring's force on the (z, z') plane is the odd
/// continuation sgn(x1) g(|x1|): the odd powers of g as they are, the even ones times sgn(x1).
struct ResidualCoefficients {
  double damping;                   ///< c
  numerics::Polynomial odd_force;   ///< the odd powers of g
  numerics::Polynomial even_force;  ///< the even powers of g
  double impact_loss;               ///< 1 - r
  RateMoments rate_moment;
  /// Share of what `kf` adds to the terms above: the jump integral
  /// lambda ( E[exp(Q(x1, x2 - sgn(x1) Y) - Q)] - 1 ) less its Kramers-Moyal series up to the
  /// fourth derivative. 1 for `kf`, else 0.
  double jump_share;
  /// Whether the plane is Zhuravlev's (z, z'), folded at a wall. Where there is none it is (y, y')
  /// itself: odd_force is all of g, even_force is 0, the damping is f = y' (damping_polynomial(y) +
  /// rayleigh y'^2), and F is unfolded_part().
  bool folded = true;
  numerics::Polynomial damping_polynomial{{}};
  double rayleigh = 0;
};

/// @param equation white (E[Y^3] and E[Y^4] are dropped), km4 or kf
ResidualCoefficients residual_coefficients(const problem::Problem& problem,
                                           problem::Equation equation);

/// The coefficients at a point of the straight path from white noise at an impact without loss
/// (fraction 0), where the density is exp( -(c/D2)(x2^2/2 + U(|x1|)) ) up to a constant, to the
/// given ones (fraction 1): 1-r, lambda E[Y], E[Y^3], E[Y^4] and the jump share are multiplied by
/// the fraction.
ResidualCoefficients partway(const ResidualCoefficients& full, double fraction);

/// Q_n's derivatives at a point; two twos stand for the second derivative in x2, and so on.
struct Derivatives {
  double q1, q2, q22, q222, q2222;
};

// F of paper (22) is split by the factor that its terms carry,
//
//     F = smooth + sgn(x1) signed + delta(x1) |x2| impact,
//
// since each factor has a quadrature rule of its own. Each part below comes with its gradient with
// respect to the derivatives of Q_n that it contains. g = g_odd + g_even is the spring's force.

/// -x2 Q_1 + [c x2 + g_odd(x1)] Q_2 + lambda E[Y^2]/2! [Q_22 + Q_2^2]
/// + lambda E[Y^4]/4! [Q_2222 + 4 Q_2 Q_222 + 3 Q_22^2 + 6 Q_2^2 Q_22 + Q_2^4] + c
double smooth_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q);
Derivatives smooth_gradient(const ResidualCoefficients& f, double x1, double x2,
                            const Derivatives& q);

/// [g_even(x1) - lambda E[Y]] Q_2 - lambda E[Y^3]/3! [Q_222 + 3 Q_2 Q_22 + Q_2^3]
double signed_part(const ResidualCoefficients& f, double x1, const Derivatives& q);
Derivatives signed_gradient(const ResidualCoefficients& f, double x1, const Derivatives& q);

/// F where there is no wall: smooth and signed parts without the sign, and any damping f,
/// -x2 Q_1 + [f + g - lambda E[Y]] Q_2 + f_v + (lambda E[Y^2] + 2D)/2! [Q_22 + Q_2^2] - ..
double unfolded_part(const ResidualCoefficients& f, double x1, double x2, const Derivatives& q);
Derivatives unfolded_gradient(const ResidualCoefficients& f, double x1, double x2,
                              const Derivatives& q);

/// The terms of the two parts above that are due to the impulses, at a point with x1 > 0
/// (side = 1) or x1 < 0 (side = -1): the Kramers-Moyal series times exp(-Q).
double series_part(const RateMoments& rate_moment, int side, const Derivatives& q);
Derivatives series_gradient(const RateMoments& rate_moment, int side, const Derivatives& q);

/// (1-r) [x2 Q_2 + 2]
double impact_part(const ResidualCoefficients& f, double x2, const Derivatives& q);
Derivatives impact_gradient(const ResidualCoefficients& f, double x2);

}  // namespace fpkcheck::epc::gaussian
