#pragma once

/// What passes for a density, and for one of the kind that was asked for. docs/closure.md says how
/// these bounds were found.
namespace fpkcheck::epc {

/// Largest density on the edge of its support, relative to the peak.
inline constexpr double kEdgeAllowed = 1e-6;

/// Largest difference of the density's mass from 1 that passes for quadrature error.
inline constexpr double kMassAllowed = 1e-4;

/// Largest residual of the energy balance, relative to the input, of a root of the formulation
/// gaussian that passes for a solution. The balance is the equation projected on x2^2 without the
/// weights, so that n = 2 meets it exactly and higher orders nearly do: 0.08 is the most of any
/// good root met. At 0.16 (r = 0.85, n = 6) E[y^2] is 20 % wrong, and roots that Newton's method
/// finds far from any stationary density miss it by 0.4 and more, with Q_n falling properly all the
/// same.
inline constexpr double kEnergyAllowed = 0.1;

/// Largest Summary::distance_to_previous of a root that passes for a solution, where the root of
/// order n-2 is itself a density. Good roots stay below 0.16 at n = 4, whose predecessor is a mere
/// Gaussian, and below 0.04 from n = 6 on.
inline constexpr double kDistanceAllowed = 0.3;

}  // namespace fpkcheck::epc
