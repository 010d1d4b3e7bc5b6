#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "numerics/interval/interval.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::backward {

using transform::StateVariable;

/// Moment E[y^n] or E[y'^n] of the stationary density, of the order n = `power`, 1 <= n <= 4.
struct PowerMoment {
  StateVariable variable;
  int power;
};

/// Weighted average int B(y) p(y) dy or int B(y') p(y') dy' of a marginal density p with the weight
/// function B. The weight B of the average is the cubic B-spline with integral 1 on five knots k_0
/// < .. < k_4. For y all knots are >= 0.
struct SmoothBin {
  StateVariable variable;
  std::array<double, 5> knots;

  /// Returns the smooth bin (cubic B-spline as weight) with knots centre + j spacing, |j| <= 2.
  static SmoothBin with_equidistant_knots(StateVariable variable, double centre, double spacing);
};

/// Impact momentum w1 = int u^2 p(a, -u) du of the stationary density p at a left wall y = a, with
/// the impact speed u. The stationarity E[L y'] = 0 with the generator L gives the impact momentum:
///
///     (1 + r) w1 = E[k y + mu y^3] - lambda E[Y].
struct ImpactMomentumFlux {};

/// Functional of the stationary density, an affine function of the mean E[f] of an integrand f:
///
///     moment           E[f]                          with f = y^n or f = y'^n,
///     smooth bin       4/(k_4 - k_0) E[f]            with f = B (k_4 - k_0)/4,
///     impact momentum  (E[f] - lambda E[Y])/(1 + r)  with f = k y + mu y^3.
///
/// The factor (k_4 - k_0)/4 gives the integrand f of a smooth bin a peak of order 1.
using StationaryFunctional = std::variant<PowerMoment, SmoothBin, ImpactMomentumFlux>;

/// Returns the functionals of the stationary density that are bounded by default: E[y], E[y^2],
/// E[y'^2], E[y^4], E[y'^4] and w1.
std::vector<StationaryFunctional> default_functionals();

/// Returns the name of a functional in tables, such as "E[y^2]", "w1", "p(y) near 0.5".
std::string functional_name(const StationaryFunctional& functional);

/// Returns the value f(y, v) of the integrand of a functional, in rounded arithmetic.
double evaluate_integrand(const StationaryFunctional& functional, const problem::Problem& problem,
                          double y, double v);

/// Returns the values of integrand_variable() at which the integrand of a functional is not smooth:
/// the knots of a smooth bin. The list is empty for polynomials.
std::vector<double> integrand_breakpoints(const StationaryFunctional& functional);

/// Returns the variable, y or y', on which the integrand of a functional depends.
StateVariable integrand_variable(const StationaryFunctional& functional);

/// @throws InputError when the power of a moment is not 1 to 4, or the knots of a smooth bin
/// violate the conditions of SmoothBin
void require_valid_functional(const StationaryFunctional& functional);

/// Returns enclosures of the Bernstein coefficients of the integrand f of a functional on the
/// segment from `from` to `to` of integrand_variable(). No kink of the integrand
/// (integrand_breakpoints()) may lie inside the segment, except by rounding of its ends.
/// @param degree degree of the Bernstein polynomials
numerics::BernsteinCoefficients enclose_integrand(const StationaryFunctional& functional,
                                                  const problem::Problem& problem,
                                                  const numerics::Interval& from,
                                                  const numerics::Interval& to, int degree);

/// Returns an upper bound of the integrand |f| for all states with |y| <= `y_bound`, |v| <=
/// `v_bound` and |k y + mu y^3| <= `force_bound`. The upper bound of the integrand is a polynomial
/// of degree <= 4 in the bounds of y, v and the force, with nonnegative coefficients.
numerics::Interval integrand_magnitude_bound(const StationaryFunctional& functional,
                                             const numerics::Interval& y_bound,
                                             const numerics::Interval& v_bound,
                                             const numerics::Interval& force_bound);

/// Returns an enclosure of a functional from an enclosure of the mean E[f] of its integrand.
numerics::Enclosure enclose_functional(const StationaryFunctional& functional,
                                       const problem::Problem& problem,
                                       const numerics::Enclosure& integrand_mean);

}  // namespace fpkcheck::backward
