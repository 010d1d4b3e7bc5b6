#pragma once

/// Limits within which a root is accepted as a density. Experiments behind them: docs/closure.md.
namespace fpkcheck::epc {

/// Largest density on the edge of its support, relative to the peak.
inline constexpr double kEdgeDensityLimit = 1e-6;

/// Largest difference of the density's mass from 1, attributed to quadrature error.
inline constexpr double kMassTolerance = 1e-4;

/// Largest residual of the energy balance, relative to the input, of a root of the formulation
/// gaussian. The balance is the equation projected on x2^2 without the weights: n = 2 satisfies it
/// exactly and higher orders approximately. The largest residual of a good root was 0.08. At 0.16
/// (r = 0.85, n = 6) E[y^2] has an error of 20 %. Roots far from any stationary density have
/// residuals of 0.4 and more, although their Q_n falls in every direction.
inline constexpr double kEnergyResidualLimit = 0.1;

/// Largest Summary::distance_to_previous of a root, applied if the root of order n-2 is itself a
/// density. Good roots are below 0.16 at n = 4, where order n-2 is a Gaussian, and below 0.04 from
/// n = 6 on.
inline constexpr double kOrderDistanceLimit = 0.3;

}  // namespace fpkcheck::epc
