#pragma once

#include "epc/half_plane/root_search_result.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Largest exp(Q_n) at the confinement level, relative to the peak, at which the search tries no
/// further level at intermediate orders.
inline constexpr double kIntermediateLevelDensity = 1e-2;
/// Largest exp(Q_n) at the confinement level, relative to the peak, at which the search tries no
/// further level at the requested order, for oscillators other than the paper's.
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
