#pragma once

#include <limits>
#include <optional>
#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Density C exp(Q_n + confinement).
struct ClosureDensity {
  Polynomial q{{}};              ///< Q_n in monomials of s and t, without its constant
  double temperature = 0;        ///< E[v^2]
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double level = 0;              ///< confinement level, or energy of the cut
  double support = 0;            ///< energy beyond which the density is 0
  /// Largest s up to which Q_n falls.
  double decay_extent = std::numeric_limits<double>::infinity();
};

/// Result of the search for a root.
struct Root {
  ClosureDensity closure;
  std::optional<ClosureDensity>
      previous;  ///< order n - 2, with a larger tolerance; empty for n = 2
  /// Largest density where it should have decayed, relative to the peak:
  /// ClosureFormulation::decay_ratio.
  double decay_ratio = 0;
  QuadratureSize quadrature{};
  /// Quadrature error: standard deviation of the change of Q_n on more points.
  double quadrature_change = 0;
  /// At the requested order, or the order that failed; iterations of all orders together.
  numerics::NewtonResult newton;
  double condition = 0;
  int homotopies = 0;   ///< number of homotopies followed after damped Newton steps failed
  std::string failure;  ///< one sentence without a root; else empty
};

}  // namespace fpkcheck::epc::half_plane
