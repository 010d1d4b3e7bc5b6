#pragma once

#include <vector>

#include "numerics/polynomials/polynomial.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

/// How the box is cut into panels.
enum class Panels {
  even,
  graded,  ///< the narrower the nearer to 0, where strong losses and rare impulses leave a spike
  /// The first of these cut further, by the same factor each: what fans out from the origin looks
  /// alike on every scale there.
  shrinking
};

/// A density's marginals at the points of a composite Gauss-Legendre rule on
/// [y_min, y_max] x [-v_max, 0] x [0, v_max], with what can be had from the same values.
struct PanelMarginals {
  std::vector<double> y;         ///< the rule's points in y
  std::vector<double> p_y, p_v;  ///< p(y) and p(y') at the rule's points
  std::vector<double> weight_y, weight_v;
  double mass = 0;
  Moments moments = {};
};

/// The box may be that of another density, so that two can be compared. Panels are those of a wall at
/// y = 0; where the density's y_min is another they are even.
PanelMarginals panel_marginals(const SmoothDensity& density, double y_max, double v_max,
                               Panels panels = Panels::even);

/// E[g(y)] for a polynomial g.
double mean_of(const PanelMarginals& marginals, const numerics::Polynomial& g);

/// L1 distance of p(y) plus that of p(y'), of marginals at the same points.
double distance(const PanelMarginals& a, const PanelMarginals& b);

}  // namespace fpkcheck::transform
