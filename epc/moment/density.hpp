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

/// Returns the density C exp(Q_n + confinement term), with a polynomial Q_n of y and v; the density
/// is 0 outside of the domain.
transform::SmoothDensity density_from_exponent(
    const ExponentPolynomial& q, const EnergySublevelSet& domain,
    const half_plane::ExponentConfinementTerm& confinement, double log_constant);

/// Returns points on the edge of the domain of a closure, with their contributions
/// DensityContourPoint::area to dA/dh.
half_plane::DensityContour energy_contour_of_domain_edge(const EnergySublevelSet& domain);

/// Returns the largest value of the exponent Q_n on the contour of an energy (EnergySublevelSet).
double largest_exponent_on_contour(const ExponentPolynomial& q, const problem::Problem& problem,
                                   double energy);

/// Decay of the maximum of the exponent Q_n on an energy contour with increasing energy.
struct ExponentDecayRange {
  double peak;  ///< largest exponent Q_n up to the first energy of the scan
  /// First energy at which the maximum of Q_n on the energy contour lies `depth` below the peak
  std::optional<double> crossing;
};

/// Scans energy contours of increasing energy until the maximum of the exponent Q_n on a contour
/// lies `depth` below the peak or rises again, or up to `last_energy`.
ExponentDecayRange find_exponent_decay_range(const ExponentPolynomial& q,
                                             const problem::Problem& problem, double first_energy,
                                             double last_energy, double depth);

/// Depth below the peak of the exponent Q_n at which exp(Q_n) is negligible: e^-42 = 6e-19 of the
/// peak of exp(Q_n). If the exponent Q_n falls by kNegligibleExponentDepth without rising again,
/// the confinement level is the energy at which Q_n lies kNegligibleExponentDepth below its peak.
inline constexpr double kNegligibleExponentDepth = 42;
/// Smallest factor by which an improved confinement level must exceed the previous level.
inline constexpr double kMinLevelRatio = 1.05;

/// Largest exp(Q_n) at an accepted confinement level, relative to the peak of exp(Q_n), at closure
/// orders below the requested order.
inline constexpr double kIntermediateLevelDensity = 1e-2;
/// Largest exp(Q_n) at an accepted confinement level, relative to the peak of exp(Q_n), at the
/// requested order of a root search from the energy-averaged density.
inline constexpr double kPreferredLevelDensity = 1e-3;
/// Largest exp(Q_n) at the confinement level, relative to the peak of exp(Q_n), of an admissible
/// density. A closure density with a larger exp(Q_n) at the confinement level decays by the
/// confinement term alone (observed for ring-shaped densities).
inline constexpr double kLevelDensityLimit = 1e-2;

/// Returns the largest exp(Q_n) at the confinement level, relative to the peak of exp(Q_n).
double density_ratio_at_confinement_level(const half_plane::ClosureDensity& closure,
                                          const problem::Problem& problem);

/// Returns the largest closure density on the edge of its support, relative to the peak density.
double density_ratio_at_edge(const half_plane::ClosureDensity& closure,
                             const problem::Problem& problem, DensityTailTreatment tail);

}  // namespace fpkcheck::epc::moment
