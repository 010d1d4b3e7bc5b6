#pragma once

#include <string>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"

/// Conversion of a root of the closure equations to a closure result, common to the formulations on
/// the half-plane y >= 0.
namespace fpkcheck::epc::half_plane {

/// Returns a closure result with the status not_converged, before the assessment of the root.
ClosureResult make_unassessed_result(const ClosureRootSearchResult& root);

/// Returns the parameters by which files store the density of a closure.
ClosedFormDensityParameters closed_form_parameters(const ClosureDensity& closure,
                                                   DensityTailTreatment tail,
                                                   ExponentCoordinates variables);

/// Contours, in the plane of y and v, of the edge of the support and of the confinement level.
struct EdgeAndConfinementLevelContours {
  DensityContour support, level;
  double density;  ///< largest density on the edge of the support, relative to the peak density
};

/// Stores condition number, coefficients of Q_n, support and tail of a root in a summary.
/// @pre the solution already contains the density
void store_half_plane_summary(const ClosureRootSearchResult& root, DensityTailTreatment tail,
                              const transform::SmoothDensity& density,
                              const StandardDeviations& sigma,
                              const EdgeAndConfinementLevelContours& edges, ClosureResult& result);

/// Sets the status of the solution. If the quadrature does not resolve the root, the status is
/// not_converged, except for an inadmissible root whose number of quadrature points was not
/// increased (is_refinement_omitted). A root of the closure is inadmissible if
/// - the formulation states a reason why the root is inadmissible;
/// - the integral of the density by an independent quadrature is not 1;
///  - too much probability lies at or beyond the confinement level: the confinement would determine
///    the density;
///  - the root is unstable under the moment equations.
/// @param quadrature_tolerance tolerance on the change of the exponent Q_n on more quadrature
///   points, in standard deviations
/// @param inadmissible_reason reason of the formulation, or empty
void set_status(const ClosureRootSearchResult& root, double quadrature_tolerance,
                const std::string& inadmissible_reason, ClosureResult& result);

/// Returns the root mean squares of displacement y and velocity v.
StandardDeviations root_mean_squares(const transform::Moments& moments);

}  // namespace fpkcheck::epc::half_plane
