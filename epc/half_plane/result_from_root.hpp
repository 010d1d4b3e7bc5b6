#pragma once

#include <string>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"

/// Conversion of a root to a result: common part of the formulations on the half-plane.
namespace fpkcheck::epc::half_plane {

/// Result before the assessment of the root: iterations and residual of the search, the status
/// not_converged, and the reason of failure.
Result make_unassessed_result(const RootSearchResult& root);

/// All parameters of the closed form except the coefficients of Q_n.
ClosedFormParameters closed_form_parameters(const ClosureDensity& closure, TailTreatment tail,
                                            ExponentCoordinates variables);

/// Contours at the edge of the support and at the confinement level.
struct BoundaryContours {
  Contour support, level;
  double density;  ///< largest density on the edge of the support, relative to the peak
};

/// Stores the condition number, the coefficients, the support and the tail in the summary of a
/// result.
/// @pre the solution already contains the density
/// @param sigma standard deviations that scale the plane
void store_half_plane_summary(const RootSearchResult& root, TailTreatment tail,
                              const transform::SmoothDensity& density,
                              const StandardDeviations& sigma, const BoundaryContours& edges,
                              Result& result);

/// Sets the status of the solution. A root that the quadrature does not resolve has the status
/// not_converged. A root is inadmissible if
///  - the formulation gives a reason;
///  - the integral of its density by an independent quadrature is not 1: moments and marginal
///    densities would have the error of this integral;
///  - too much probability lies at or beyond the confinement level: the confinement would determine
///    the density.
/// The status is not an error estimate: the distance to another order does not give the error of
/// the density.
/// @param quadrature_tolerance tolerance on the change of Q_n on more points, in standard
///   deviations
/// @param inadmissible_reason reason of the formulation, or empty
void set_status(const RootSearchResult& root, double quadrature_tolerance,
                const std::string& inadmissible_reason, Result& result);

/// The root-mean-square displacement and velocity.
StandardDeviations root_mean_squares(const transform::Moments& moments);

}  // namespace fpkcheck::epc::half_plane
