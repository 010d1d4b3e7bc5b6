#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

/// Rule for the widths of the panels of the quadrature rule.
enum class PanelSpacing {
  uniform,
  /// Narrower towards 0, where strong dissipation and rare impulses cause a spike of the density.
  graded,
  /// Like `graded`, but the first panel is subdivided geometrically, for densities that are
  /// self-similar near the origin.
  geometric
};

/// Marginal densities at the points of a composite Gauss-Legendre rule on [y_min, y_max] x [-v_max,
/// 0] and [y_min, y_max] x [0, v_max]. Mass and moments are computed from the same values of the
/// density.
struct PanelMarginals {
  std::vector<double> y;         ///< points of the quadrature rule in y
  std::vector<double> p_y, p_v;  ///< p(y) and p(y') at the quadrature points
  std::vector<double> weight_y, weight_v;
  double mass = 0;
  Moments moments = {};
};

/// Marginals of a density, computed on a given domain. For a comparison of two densities the domain
/// may be that of the other density. `panels` applies to a density with a wall at y = 0; for
/// another y_min, the panels of y have equal widths.
PanelMarginals panel_marginals(const SmoothDensity& density, double y_max, double v_max,
                               PanelSpacing panels = PanelSpacing::uniform);

/// The expectation E[g(y)] of a polynomial g of the displacement.
double mean_of_displacement_polynomial(const PanelMarginals& marginals,
                                       const numerics::Polynomial& g);

/// The distance of two densities: the L1 distance of the marginals p(y) plus the L1 distance of the
/// marginals p(y').
/// @pre a and b have the same quadrature points
double distance(const PanelMarginals& a, const PanelMarginals& b);

}  // namespace fpkcheck::transform
