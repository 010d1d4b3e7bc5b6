#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::backward {

enum class Axis { displacement, velocity };

/// E[y^n] or E[y'^n], 1 <= n <= 4.
struct PowerMean {
  Axis axis;
  int power;
};

/// The average of p(y) or p(y') with a cubic B-spline on five knots as its weight: of integral 1,
/// of width half the range of the knots. For y all knots are >= 0.
struct SmoothBin {
  Axis axis;
  std::array<double, 5> knots;

  /// The cardinal bin with its peak at `centre` and knots `spacing` apart.
  static SmoothBin cardinal(Axis axis, double centre, double spacing);
};

/// w1 = int u^2 p(a, -u) du, the momentum that impacts carry to a wall at the left, y = a: from
/// E[L y'] = 0,
///
///     (1 + r) w1 = E[k y + mu y^3] - lambda E[Y].
struct ImpactMomentum {};

/// A stationary expectation that can be bounded.
using Functional = std::variant<PowerMean, SmoothBin, ImpactMomentum>;

/// E[y], E[y^2], E[y'^2], E[y^4], E[y'^4] and w1.
std::vector<Functional> standard_functionals();

/// "E[y^2]", "w1", "p(y) near 0.5"
std::string name(const Functional& functional);

/// The f whose expectation is taken, rounded; for w1 it is k y + mu y^3. A smooth bin is without
/// its factor 4/(k_4 - k_0), so that its peak is of order 1.
double integrand(const Functional& functional, const problem::Problem& problem, double y, double v);

/// Where the integrand is not smooth; none for polynomials.
std::vector<double> breaks(const Functional& functional);
Axis axis_of(const Functional& functional);

/// @throws InputError when it is not one of those described above
void validate(const Functional& functional);

}  // namespace fpkcheck::backward
