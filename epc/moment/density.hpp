#pragma once

#include <optional>

#include "epc/form/exponent_polynomial.hpp"
#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/moment/energy_domain.hpp"
#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc::moment {

/// Returns the density C exp(Q_n + confinement), where the polynomial Q_n is a polynomial of y and
/// v; 0 outside of the domain.
transform::SmoothDensity density_from_exponent(
    const ExponentPolynomial& q, const EnergySublevelSet& domain,
    const half_plane::ExponentConfinementTerm& confinement, double log_constant);

/// Returns points on the edge of the domain, with DensityContourPoint::area.
half_plane::DensityContour energy_contour_of_domain_edge(const EnergySublevelSet& domain);

/// Returns the largest exponent Q_n on the contour of an energy (EnergySublevelSet).
double largest_exponent_on_contour(const ExponentPolynomial& q, const problem::Problem& problem,
                                   double energy);

/// Decay of the largest exponent Q_n on an energy contour, with growing energy.
struct ExponentDecayRange {
  double peak;  ///< largest exponent Q_n up to the first energy of the scan
  /// First energy at which the largest exponent Q_n on the contour lies `depth` below the peak
  std::optional<double> crossing;
};

/// Scans contours of growing energy until the largest exponent Q_n on a contour lies `depth` below
/// the peak or rises again, or up to `last_energy`.
ExponentDecayRange find_exponent_decay_range(const ExponentPolynomial& q,
                                             const problem::Problem& problem, double first_energy,
                                             double last_energy, double depth);

/// Depth below the peak of the exponent Q_n at which exp(Q_n) is negligible: e^-42 = 6e-19 of the
/// peak. If the exponent Q_n falls by kNegligibleExponentDepth without a rise, the confinement
/// level is the energy at which Q_n lies kNegligibleExponentDepth below the peak.
inline constexpr double kNegligibleExponentDepth = 42;
/// Smallest factor by which an improved confinement level must exceed the present confinement
/// level.
inline constexpr double kMinLevelRatio = 1.05;

/// Largest exp(Q_n) at an accepted confinement level, relative to the peak, at intermediate closure
/// orders.
inline constexpr double kIntermediateLevelDensity = 1e-2;
/// Largest exp(Q_n) at an accepted confinement level, relative to the peak, at the requested
/// closure order of a search from energy averaging.
inline constexpr double kPreferredLevelDensity = 1e-3;
/// Largest exp(Q_n) at the confinement level, relative to the peak, of an admissible density. A
/// density with a larger ratio decays by the confinement alone (observed for ring-shaped
/// densities).
inline constexpr double kLevelDensityLimit = 1e-2;

/// Returns the largest exp(Q_n) on the contour of the confinement level, relative to the peak.
double density_ratio_at_confinement_level(const half_plane::ClosureDensity& closure,
                                          const problem::Problem& problem);

/// Returns the largest density on the edge of the support, relative to the peak density.
double density_ratio_at_edge(const half_plane::ClosureDensity& closure,
                             const problem::Problem& problem, DensityTailTreatment tail);

}  // namespace fpkcheck::epc::moment
