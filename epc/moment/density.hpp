#pragma once

#include <optional>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/moment/energy_domain.hpp"
#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::moment {

/// Density C exp(Q_n + confinement), where Q_n is a polynomial of y and v; 0 outside of the domain.
transform::SmoothDensity density_from_exponent(const Polynomial& q, const EnergyDomain& domain,
                                               const half_plane::Confinement& confinement,
                                               double log_constant);

/// Energy contour along the edge of a domain.
half_plane::Contour edge_contour(const EnergyDomain& domain);

/// Largest Q_n on the contour of an energy, which is defined as in EnergyDomain.
double largest_exponent_on_contour(const Polynomial& q, const problem::Problem& problem,
                                   double energy);

/// Decay with growing energy of the largest Q_n on an energy contour.
struct DecayScan {
  double peak;  ///< largest Q_n up to the first energy of the scan
  /// first energy at which the largest Q_n on the contour lies `depth` below the peak
  std::optional<double> crossing;
};

/// Scans contours of growing energy until the largest Q_n on a contour lies `depth` below the peak.
/// The energy `crossing` is empty if Q_n rises before this depth, or does not reach this depth up
/// to the energy `last_energy`.
DecayScan scan_decay(const Polynomial& q, const problem::Problem& problem, double first_energy,
                     double last_energy, double depth);

/// Depth below the peak of Q_n at which exp(Q_n) is negligible: e^-42 = 6e-19 of the peak. If Q_n
/// falls to this depth without a rise, the confinement level is the energy at this depth.
inline constexpr double kNegligibleDepth = 42;
/// Smallest ratio of a new confinement level to the present level for which the search solves the
/// equations again.
inline constexpr double kMinLevelRatio = 1.05;

/// Largest exp(Q_n) at the confinement level, relative to the peak, at which the search tries no
/// further level at intermediate orders.
inline constexpr double kIntermediateLevelDensity = 1e-2;
/// Largest exp(Q_n) at the confinement level, relative to the peak, at which the search tries no
/// further level at the requested order, in a search that starts from energy averaging.
inline constexpr double kPreferredLevelDensity = 1e-3;
/// Largest exp(Q_n) at the confinement level, relative to the peak, of an admissible density. A
/// larger value means that the density decays by the confinement alone (in ring-shaped densities).
inline constexpr double kLevelDensityLimit = 1e-2;

/// Largest exp(Q_n) on the energy contour of the confinement level, relative to the peak.
double density_ratio_at_level(const half_plane::ClosureDensity& closure,
                              const problem::Problem& problem);

/// Largest density on the edge of the support, relative to the peak.
double density_ratio_at_edge(const half_plane::ClosureDensity& closure,
                             const problem::Problem& problem, TailTreatment tail);

}  // namespace fpkcheck::epc::moment
