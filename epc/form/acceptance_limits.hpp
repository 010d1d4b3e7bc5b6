#pragma once

/// Limits within which the density of a root is accepted. docs/closure.md has the experiments that
/// set the limits.
namespace fpkcheck::epc {

/// Largest accepted density on the edge of the support, relative to the peak of the density.
inline constexpr double kEdgeDensityLimit = 1e-6;

/// Largest accepted difference between the integral of the density and 1. A smaller difference is
/// attributed to quadrature error.
inline constexpr double kMassTolerance = 1e-4;

/// Largest accepted residual of the energy balance, relative to the input power, for a root of the
/// formulation gaussian. The energy balance is the equation projected on x2^2 without the weights.
/// A root of order n = 2 satisfies the balance exactly, and roots of higher order approximately.
/// The largest residual of a good root was 0.08. At the residual 0.16 (r = 0.85, n = 6) E[y^2] has
/// an error of 20 %. Roots far from any stationary density have residuals of 0.4 and more, although
/// Q_n falls in every direction.
inline constexpr double kEnergyResidualLimit = 0.1;

/// Largest accepted Summary::distance_to_previous of a root. The limit applies only if the density
/// of order n-2 is admissible. The distance of good roots is below 0.16 at n = 4, where the density
/// of order n-2 is a Gaussian, and below 0.04 from n = 6 on.
inline constexpr double kOrderDistanceLimit = 0.3;

}  // namespace fpkcheck::epc
