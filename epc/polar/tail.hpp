#pragma once

#include <optional>
#include <utility>

#include "epc/polar/coordinates.hpp"
#include "epc/polynomial.hpp"
#include "epc/support.hpp"

namespace fpkcheck::epc::polar {

/// The largest Q_n(rho, theta) at an amplitude.
double largest_at(const Polynomial& q, double rho);

/// What Q_n does from the origin outwards, amplitude by amplitude.
struct Fall {
  std::optional<double> reached;  ///< least amplitude at which Q_n lies `depth` below its peak
  double turning;                 ///< where it stopped to fall, or `farthest`
};

/// Follows the largest Q_n of an amplitude until it lies `depth` below its peak, or rises again.
Fall fall_of(const Polynomial& q, double depth, double farthest);

/// Probability beyond an amplitude if the density fell from there on like exp(-h/T).
/// @param log_normalisation of exp(Q_n)
double probability_beyond(const Polynomial& q, const Coordinates& coordinates, double rho,
                          double temperature, double log_normalisation);

/// Least and greatest distance of the half-circle rho from the origin in a scaled plane.
std::pair<double, double> radii(const Coordinates& coordinates, double rho,
                                const Deviations& sigma);

/// Condition (19) for a polynomial of rho and theta: its highest power of rho has a constant
/// coefficient, so that it falls at every phase or at none. Radii are rho/sigma_2.
LeadingForm leading_form(const Polynomial& q, const Deviations& sigma);

}  // namespace fpkcheck::epc::polar
