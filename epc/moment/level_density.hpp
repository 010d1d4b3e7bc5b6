#pragma once

#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Largest exp(Q_n) at the confinement level, relative to the peak, at which no further level is
/// tried: at intermediate orders, and at the requested order beyond the paper's class.
inline constexpr double kIntermediateLevelDensity = 1e-2;
inline constexpr double kPreferredLevelDensity = 1e-3;
/// Limit of an admissible density. With more, the confinement alone makes the density decay
/// (rings).
inline constexpr double kLevelDensityLimit = 1e-2;

/// Largest exp(Q_n) on the contour of the confinement level, relative to the peak.
double level_density(const half_plane::ClosureDensity& closure, const problem::Problem& problem);

/// Largest density on the edge of the support, relative to the peak.
double edge_density(const half_plane::ClosureDensity& closure, const problem::Problem& problem,
                    Tail tail);

}  // namespace fpkcheck::epc::moment
