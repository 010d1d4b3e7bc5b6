#pragma once

#include <vector>

#include "epc/form/polynomial.hpp"

namespace fpkcheck::epc {

/// sigma_1 and sigma_2, the deviations by which the plane is scaled.
struct Deviations {
  double x1;
  double x2;
};

/// A direction (cos theta, sin theta) in the scaled plane (x1/sigma_1, x2/sigma_2).
struct Direction {
  double x1;
  double x2;
};

/// Coefficients of rho -> Q_n along a direction of the scaled plane, lowest power first, up to the
/// highest that is not zero.
using Ray = std::vector<double>;

/// Radii are looked at in such steps, and no further than kFarthest.
inline constexpr double kRadialStep = 0.1;
inline constexpr double kFarthest = 15;

/// The directions that are looked at: all round in equal steps, those on the axes exactly there, so
/// that a term which vanishes on an axis does vanish.
const std::vector<Direction>& directions();

/// How many of them, from the first on, differ: opposite ones are alike for a Q_n of even degrees
/// only.
std::size_t distinct_directions(const Polynomial& q);

Ray ray(const Polynomial& q, const Deviations& sigma, const Direction& direction);

}  // namespace fpkcheck::epc
