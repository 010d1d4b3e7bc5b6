#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "numerics/interval/interval.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

enum class Axis { displacement, velocity };

/// Moment E[y^n] or E[y'^n] with n = `power`, 1 <= n <= 4.
struct PowerMoment {
  Axis axis;
  int power;
};

/// Average of p(y) or p(y') with a cubic B-spline of integral 1 on five knots as weight. For y all
/// knots are >= 0.
struct SmoothBin {
  Axis axis;
  std::array<double, 5> knots;

  /// Returns the bin with five equidistant knots around `centre`.
  static SmoothBin with_equidistant_knots(Axis axis, double centre, double spacing);
};

/// Impact momentum w1 = int u^2 p(a, -u) du at a left wall y = a. With the generator L, the
/// stationarity condition E[L y'] = 0 gives
///
///     (1 + r) w1 = E[k y + mu y^3] - lambda E[Y].
struct ImpactMomentum {};

using Functional = std::variant<PowerMoment, SmoothBin, ImpactMomentum>;

/// Returns the default functionals E[y], E[y^2], E[y'^2], E[y^4], E[y'^4] and w1.
std::vector<Functional> default_functionals();

/// Returns the name of a functional in tables and messages, such as "E[y^2]", "w1", "p(y) near
/// 0.5".
std::string name(const Functional& functional);

/// Returns the rounded value at (y, v) of the integrand f, whose mean E[f] determines the
/// functional. For w1 the integrand is k y + mu y^3. For a smooth bin the integrand omits the
/// factor 4/(k_4 - k_0) of the B-spline, so that the peak of f is of order 1.
double integrand(const Functional& functional, const problem::Problem& problem, double y, double v);

/// Returns the points at which the integrand is not smooth; empty for polynomials.
std::vector<double> non_smooth_points(const Functional& functional);
Axis axis_of(const Functional& functional);

/// @throws InputError when a power is not 1 to 4, or the knots of a smooth bin violate the
/// conditions of SmoothBin
void validate(const Functional& functional);

/// Returns enclosed Bernstein coefficients of the integrand on the axis segment from `from` to
/// `to`. The integrand is smooth on the segment, except for rounding of the ends of the segment.
numerics::BernsteinCoefficients integrand_enclosure(const Functional& functional,
                                                    const problem::Problem& problem,
                                                    const numerics::Interval& from,
                                                    const numerics::Interval& to, int degree);

/// Returns an upper bound of the magnitude |f| of the integrand for 0 <= y <= `y`, |v| <= `v` and k
/// y + mu y^3 <= `force`. The bound is a polynomial of degree <= 4 in `y`, `v` and `force`, with
/// nonnegative coefficients.
numerics::Interval integrand_magnitude_bound(const Functional& functional,
                                             const numerics::Interval& y,
                                             const numerics::Interval& v,
                                             const numerics::Interval& force);

/// Returns an enclosure of the functional, from an enclosure of the mean of the integrand.
numerics::Enclosure enclose_functional(const Functional& functional,
                                       const problem::Problem& problem,
                                       const numerics::Enclosure& mean);

}  // namespace fpkcheck::backward
