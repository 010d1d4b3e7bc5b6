#pragma once

#include <array>

#include "epc/form/exponent_polynomial.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Products lambda E[Y^j] of the rate and moments of impulses, j = 1 .. 4; entry 0 is unused.
using RateTimesMoments = std::array<double, 5>;

/// Coefficients of the residual F in equation (22) of the paper. On the (z, z') plane the spring
/// force g becomes sgn(x1) g(|x1|): odd powers of g are unchanged, and even powers are multiplied
/// by sgn(x1). For a problem with formulas, force and damping are the linear terms whose density
/// under white noise is the Gaussian weight. The class ProjectedFormulaTerms projects the remaining
/// terms with formulas.
struct DensityEquationCoefficients {
  double damping;
  numerics::Polynomial odd_force;
  numerics::Polynomial even_force;
  double impact_loss;  ///< 1 - r with the restitution coefficient r
  RateTimesMoments rate_times_moment;
  /// Factor of the remainder of the jump integral: 1 for the equation `kf`, else 0.
  double jump_fraction;
  /// Whether the coordinates x1, x2 are Zhuravlev's coordinates (z, z') of paper (5). Without a
  /// wall the coordinates are (y, y'), odd_force is the whole force g, even_force is 0, and the
  /// damping force is y' (damping_polynomial(y) + rayleigh y'^2).
  bool folded = true;
  numerics::Polynomial damping_polynomial{{}};
  double rayleigh = 0;
  double formula_fraction = 0;  ///< factor of the terms by formulas: 1 with formulas, else 0
};

/// @param equation density equation white (without E[Y^3] and E[Y^4]), km4 or kf
/// @param sigma deviations of the Gaussian weights; needed for a problem with formulas
DensityEquationCoefficients residual_coefficients(const problem::Problem& problem,
                                                  problem::DensityEquation equation,
                                                  const StandardDeviations& sigma = {});

/// Returns the coefficients of a problem between white noise with elastic impacts (fraction 0) and
/// the full problem (fraction 1): 1-r, lambda E[Y], lambda E[Y^3], lambda E[Y^4], jump_fraction and
/// formula_fraction are multiplied by the fraction. At fraction 0 (white noise, elastic impacts)
/// the exact density is C exp( -(c/D2)(x2^2/2 + U(|x1|)) ), with the damping c, the noise
/// coefficient D2 and the potential U.
DensityEquationCoefficients homotopy_coefficients(const DensityEquationCoefficients& full,
                                                  double fraction);

/// Derivatives of the polynomial Q_n at a point: q1 is the first derivative in x1, q22 is the
/// second derivative in x2.
struct ExponentPartialDerivatives {
  double q1, q2, q22, q222, q2222;
};

// The residual F in equation (22) of the paper is split by the factors of its terms,
//
//     F = smooth + sgn(x1) signed + delta(x1) |x2| impact,
//
// since each factor has its own quadrature rule. The gradient of each part of the residual F is
// with respect to the derivatives of the exponent Q_n. The spring force is g = g_odd + g_even.

/// Returns the part of the residual F without a discontinuous factor, -x2 Q_1 + [c x2 + g_odd(x1)]
/// Q_2 + lambda E[Y^2]/2! [Q_22 + Q_2^2] + lambda E[Y^4]/4! [Q_2222 + 4 Q_2 Q_222 + 3 Q_22^2 + 6
/// Q_2^2 Q_22 + Q_2^4] + c
double residual_part_without_x1_sign(const DensityEquationCoefficients& f, double x1, double x2,
                                     const ExponentPartialDerivatives& q);
ExponentPartialDerivatives smooth_residual_gradient(const DensityEquationCoefficients& f, double x1,
                                                    double x2, const ExponentPartialDerivatives& q);

/// Returns the part of the residual F with the factor sgn(x1), [g_even(x1) - lambda E[Y]] Q_2 -
/// lambda E[Y^3]/3! [Q_222 + 3 Q_2 Q_22 + Q_2^3]
double residual_part_odd_in_x1_sign(const DensityEquationCoefficients& f, double x1,
                                    const ExponentPartialDerivatives& q);
ExponentPartialDerivatives signed_residual_gradient(const DensityEquationCoefficients& f, double x1,
                                                    const ExponentPartialDerivatives& q);

/// Returns the residual F without a wall, for any damping force f and restoring force g, -x2 Q_1 +
/// [f + g - lambda E[Y]] Q_2 + f_v + (lambda E[Y^2] + 2D)/2! [Q_22 + Q_2^2] - .., followed by the
/// terms with E[Y^3] and E[Y^4]
double residual_without_wall(const DensityEquationCoefficients& f, double x1, double x2,
                             const ExponentPartialDerivatives& q);
ExponentPartialDerivatives residual_without_wall_gradient(const DensityEquationCoefficients& f,
                                                          double x1, double x2,
                                                          const ExponentPartialDerivatives& q);

/// Returns the truncated Kramers-Moyal series applied to the density exp(Q), divided by exp(Q).
/// @param side 1 for x1 > 0, -1 for x1 < 0
double kramers_moyal_residual_part(const RateTimesMoments& rate_times_moment, int side,
                                   const ExponentPartialDerivatives& q);
ExponentPartialDerivatives kramers_moyal_residual_gradient(
    const RateTimesMoments& rate_times_moment, int side, const ExponentPartialDerivatives& q);

/// Returns the part of the residual F that represents the impacts, with the factor delta(x1) |x2|:
/// (1-r) [x2 Q_2 + 2]
double impact_residual_part(const DensityEquationCoefficients& f, double x2,
                            const ExponentPartialDerivatives& q);
ExponentPartialDerivatives impact_residual_gradient(const DensityEquationCoefficients& f,
                                                    double x2);

}  // namespace fpkcheck::epc::gaussian
