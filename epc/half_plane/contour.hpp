#pragma once

#include <utility>
#include <vector>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"

namespace fpkcheck::epc::half_plane {

/// A point of the contour of an energy h.
struct ContourPoint {
  double s, t;  ///< the coordinates of Q_n, see Points
  double y, v;
  double area;  ///< share of dA/dh, A being the area inside
};
using Contour = std::vector<ContourPoint>;

/// Least and greatest distance of a contour from the origin in a scaled plane.
std::pair<double, double> radii(const Contour& contour, const Deviations& sigma);

/// Probability beyond a contour if the density fell from there on like exp(-h/T): T oint p dA/dh.
/// @param temperature T
/// @param log_normalisation of exp(Q_n)
double probability_beyond(const Polynomial& q, const Contour& contour, double temperature,
                          double log_normalisation);

}  // namespace fpkcheck::epc::half_plane
