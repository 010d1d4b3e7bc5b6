#pragma once

#include <utility>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"

namespace fpkcheck::epc::half_plane {

/// Point on the contour of an energy h.
struct ContourPoint {
  double s, t;  ///< coordinates of Q_n, see QuadraturePoints
  double y, v;
  double area;  ///< contribution to dA/dh, A the area inside the contour
};
using Contour = std::vector<ContourPoint>;

/// Smallest and largest distance of a contour from the origin in the plane scaled by sigma.
std::pair<double, double> radii(const Contour& contour, const Deviations& sigma);

/// Estimate of the probability beyond a contour: T oint p dA/dh, exact for a density that decays
/// like exp(-h/T).
/// @param temperature T
/// @param log_normalisation ln of the integral of the density before normalisation
double probability_beyond(const Polynomial& q, const Contour& contour, double temperature,
                          double log_normalisation);

}  // namespace fpkcheck::epc::half_plane
