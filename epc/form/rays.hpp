#pragma once

#include <vector>

#include "epc/form/polynomial.hpp"

namespace fpkcheck::epc {

/// Standard deviations sigma_1 and sigma_2 that scale the coordinates x1 and x2.
struct StandardDeviations {
  double x1;
  double x2;
};

/// A direction (cos theta, sin theta) in the scaled plane (x1/sigma_1, x2/sigma_2).
struct Direction {
  double x1;
  double x2;
};

/// Coefficients of the polynomial rho -> Q_n along a direction of the scaled plane, lowest power
/// first. The last coefficient is not 0.
using RayCoefficients = std::vector<double>;

/// Step and upper limit of the radius in radial scans, in standard deviations.
inline constexpr double kRadialStep = 0.1;
inline constexpr double kLargestRadius = 15;

/// Directions at equal angles over the whole circle. The directions along the axes are exact: a
/// term that vanishes on an axis evaluates to 0.
const std::vector<Direction>& scan_directions();

/// Number of leading entries of scan_directions() along which the restrictions of Q_n are distinct.
/// If all degrees of Q_n are even, opposite directions are equivalent, and the first half of the
/// directions suffices.
std::size_t distinct_direction_count(const Polynomial& q);

/// Restricts Q_n to a direction of the scaled plane.
RayCoefficients restrict_to_ray(const Polynomial& q, const StandardDeviations& sigma,
                                const Direction& direction);

}  // namespace fpkcheck::epc
