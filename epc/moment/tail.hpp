#pragma once

#include <optional>
#include <utility>

#include "epc/basis.hpp"
#include "epc/moment/energy_domain.hpp"
#include "epc/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

/// The largest Q_n on the contour of an energy (EnergyDomain), y >= 0.
double largest_on_contour(const Polynomial& q, const problem::Problem& problem, double energy);

/// What Q_n does from one energy outwards, contour by contour.
struct Fall {
  double peak;                    ///< largest Q_n up to the first energy
  std::optional<double> reached;  ///< the energy at which Q_n has fallen by the depth asked for
};

/// Follows the largest Q_n on contours of growing energy until it lies `depth` below its peak
/// everywhere on one. Nothing is reached when it rises before, or at `farthest`.
Fall fall_of(const Polynomial& q, const problem::Problem& problem, double from, double farthest,
             double depth);

/// Least and greatest distance of a domain's edge from the origin in a scaled plane.
std::pair<double, double> radii(const EnergyDomain& domain, const Deviations& sigma);

/// Probability beyond an energy E if the density fell from there on like exp(-h/T):
/// T oint p dA/dh.
/// @param log_normalisation of exp(Q_n)
double probability_beyond(const Polynomial& q, const problem::Problem& problem, double energy,
                          double temperature, double log_normalisation);

}  // namespace fpkcheck::epc::moment
