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
  double area;  ///< contribution of the point to dA/dh, where A is the area inside the contour
};
using Contour = std::vector<ContourPoint>;

/// Smallest and largest distance from the origin of the points of a contour, in the plane scaled by
/// sigma.
std::pair<double, double> radius_range(const Contour& contour, const StandardDeviations& sigma);

/// Estimate of the probability outside a contour: T oint p dA/dh. The estimate is exact for a
/// density that decays like exp(-h/T).
/// @param temperature temperature T of this decay
/// @param log_normalisation ln of the integral of the density before its normalisation
double probability_beyond_contour(const Polynomial& q, const Contour& contour, double temperature,
                                  double log_normalisation);

}  // namespace fpkcheck::epc::half_plane
