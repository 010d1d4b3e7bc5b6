#pragma once

#include <limits>
#include <optional>
#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/points.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// A density C exp(Q_n + confinement).
struct Shape {
  Polynomial q{{}};              ///< Q_n in monomials of s and t, without its constant
  double temperature = 0;        ///< E[v^2]
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double level = 0;              ///< energy of the confinement or the cut
  double support = 0;            ///< energy up to which the density is used
  /// The coordinate s up to which Q_n falls as a density's exponent does.
  double trusted = std::numeric_limits<double>::infinity();
};

/// What was found.
struct Root {
  Shape shape;
  std::optional<Shape> previous;  ///< of order n - 2, to a rough tolerance; none for n = 2
  /// Largest density at the place that the formulation looks at, relative to the peak:
  /// Setting::remains.
  double remains = 0;
  QuadratureSize quadrature{};
  /// By how much the points matter: the standard deviation of the change of Q_n that more of them
  /// make.
  double quadrature_change = 0;
  /// At the order asked for, or the one that failed; iterations in all.
  numerics::NewtonResult newton;
  double condition = 0;
  int homotopies = 0;   ///< how often damped Newton steps were lost and a homotopy was followed
  std::string failure;  ///< one sentence when there is no root
};

}  // namespace fpkcheck::epc::half_plane
