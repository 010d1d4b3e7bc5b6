#pragma once

#include <limits>
#include <optional>
#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Density C exp(Q_n + confinement) of the closure, by its parameters.
struct ClosureDensity {
  Polynomial q{{}};              ///< Q_n in monomials of s and t, without the constant term
  double temperature = 0;        ///< E[v^2]
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double level = 0;              ///< confinement level, or energy beyond which the density is cut
  double support = 0;            ///< energy beyond which the density is 0
  /// Largest s up to which Q_n falls; Q_n may rise at larger s.
  double decay_extent = std::numeric_limits<double>::infinity();
};

/// Result of the search for a root.
struct RootSearchResult {
  ClosureDensity closure;
  /// Density of order n - 2, solved with a larger tolerance; empty for n = 2.
  std::optional<ClosureDensity> previous;
  /// Largest density in the region where the density should have decayed, relative to the peak, by
  /// ClosureFormulation::decay_ratio.
  double decay_ratio = 0;
  QuadratureSize quadrature{};
  /// Estimated quadrature error: standard deviation of the change of Q_n on more points.
  double quadrature_change = 0;
  /// Result of Newton's method at the requested order, or at the order that failed. The number of
  /// iterations is the sum over all orders.
  numerics::NewtonResult newton;
  double condition = 0;  ///< condition number of the Jacobian at the root, by condition_number()
  int homotopies = 0;    ///< number of homotopies followed after damped Newton steps failed
  std::string failure;   ///< reason why no root was found, one sentence; else empty
};

}  // namespace fpkcheck::epc::half_plane
