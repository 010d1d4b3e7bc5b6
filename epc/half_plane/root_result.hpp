#pragma once

#include <string>

#include "epc/half_plane/contour.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/summary.hpp"

/// From a root to a result: common part of the formulations on the half-plane.
namespace fpkcheck::epc::half_plane {

/// Result with iterations and residual of the search, status not_converged and the reason of
/// failure.
Result make_result(const Root& root);

/// Parameters of the closed form besides the coefficients.
Frame frame_of(const ClosureDensity& closure, Tail tail, Variables variables);

/// Contours at the edge of the support and at the confinement level.
struct BoundaryContours {
  Contour support, level;
  double density;  ///< largest density on the edge of the support, relative to the peak
};

/// Stores condition number, coefficients, support and tail in the summary. The solution already
/// contains the density.
/// @param sigma deviations that scale the plane
void fill_summary(const Root& root, Tail tail, const transform::SmoothDensity& density,
                  const Deviations& sigma, const BoundaryContours& edges, Result& result);

/// Sets the status. A root that the quadrature does not resolve is not_converged. A root is
/// inadmissible if
///  - the formulation states a reason;
///  - its mass by an independent quadrature is not 1: moments and marginals would have this error;
///  - too much probability lies at or beyond the confinement level: the confinement would determine
///    the density.
/// The status is no error estimate: no distance to another order gives the error of the density.
/// @param quadrature_tolerance tolerance on the change of Q_n on more points, in standard
///   deviations
/// @param inadmissible_reason reason of the formulation, or empty
void set_status(const Root& root, double quadrature_tolerance,
                const std::string& inadmissible_reason, Result& result);

/// Root-mean-square displacement and velocity.
Deviations deviations(const transform::Moments& moments);

}  // namespace fpkcheck::epc::half_plane
