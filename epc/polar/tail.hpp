#pragma once

#include <optional>

#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/contour.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::epc::polar {

/// The half-circle of an amplitude, as points.
half_plane::Contour contour(const Coordinates& coordinates, double rho);

/// The largest Q_n(rho, theta) at an amplitude.
double largest_at(const Polynomial& q, double rho);

/// What Q_n does from the origin outwards, amplitude by amplitude.
struct Fall {
  std::optional<double> reached;  ///< least amplitude at which Q_n lies `depth` below its peak
  double turning;                 ///< where it stopped to fall, or `farthest`
};

/// Follows the largest Q_n of an amplitude until it lies `depth` below its peak, or rises again.
Fall fall_of(const Polynomial& q, double depth, double farthest);

/// Condition (19) for a polynomial of rho and theta: its highest power of rho has a constant
/// coefficient, so that it falls at every phase or at none. Radii are rho/sigma_2.
LeadingForm leading_form_in_amplitude(const Polynomial& q, const Deviations& sigma);

}  // namespace fpkcheck::epc::polar
