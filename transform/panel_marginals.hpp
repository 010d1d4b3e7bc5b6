#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

/// Widths of the panels of the quadrature rule.
enum class PanelSpacing {
  uniform,
  graded,  ///< narrower towards 0, where strong losses and rare impulses leave a spike
  /// Graded, with the first panel subdivided geometrically: for densities that are self-similar
  /// about the origin.
  geometric
};

/// Marginals of a density at the points of a composite Gauss-Legendre rule on
/// [y_min, y_max] x [-v_max, 0] and [y_min, y_max] x [0, v_max], with the mass and the moments from
/// the same values.
struct PanelMarginals {
  std::vector<double> y;         ///< points of the rule in y
  std::vector<double> p_y, p_v;  ///< p(y) and p(y') at the points of the rule
  std::vector<double> weight_y, weight_v;
  double mass = 0;
  Moments moments = {};
};

/// Marginals of a density on a box, which may be the box of another density to compare with.
/// `panels` applies to a wall at y = 0; for another y_min the panels of y are of equal width.
PanelMarginals panel_marginals(const SmoothDensity& density, double y_max, double v_max,
                               PanelSpacing panels = PanelSpacing::uniform);

/// E[g(y)] for a polynomial g.
double displacement_mean(const PanelMarginals& marginals, const numerics::Polynomial& g);

/// L1 distance of p(y) plus L1 distance of p(y').
/// @pre both have the same points
double distance(const PanelMarginals& a, const PanelMarginals& b);

}  // namespace fpkcheck::transform
