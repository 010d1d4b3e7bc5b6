#pragma once

#include <vector>

#include "epc/form/polynomial.hpp"

namespace fpkcheck::epc {

/// Standard deviations sigma_1 and sigma_2 that scale the plane.
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
/// highest nonzero one.
using Ray = std::vector<double>;

/// Step and upper limit of radial scans, in deviations.
inline constexpr double kRadialStep = 0.1;
inline constexpr double kLargestRadius = 15;

/// Directions at equal angles over the whole circle. Those on the axes are exact, so that a term
/// that vanishes on an axis evaluates to 0.
const std::vector<Direction>& directions();

/// Number of leading entries of directions() in which Q_n differs. If all degrees of Q_n are even,
/// opposite directions are equivalent and half of the entries suffice.
std::size_t distinct_direction_count(const Polynomial& q);

Ray ray(const Polynomial& q, const Deviations& sigma, const Direction& direction);

}  // namespace fpkcheck::epc
