#pragma once

#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Largest exp(Q_n) at the level, relative to the peak, that needs no other level: on the way, and
/// at the order asked for beyond the paper's class.
inline constexpr double kLevelDensityOnTheWay = 1e-2;
inline constexpr double kLevelDensityWanted = 1e-3;
/// Largest that is taken there: with more, the confinement alone holds the density (rings).
inline constexpr double kLevelDensityAllowed = 1e-2;

/// The largest exp(Q_n) on the contour of the level, relative to the peak.
double level_density(const half_plane::Shape& shape, const problem::Problem& problem);

/// The largest density on the edge of the support, relative to the peak.
double edge_density(const half_plane::Shape& shape, const problem::Problem& problem, Tail tail);

}  // namespace fpkcheck::epc::moment
