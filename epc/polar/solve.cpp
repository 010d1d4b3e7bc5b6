#include <cmath>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/formulations.hpp"
#include "epc/half_plane/newton.hpp"
#include "epc/half_plane/root_assessment.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/half_plane/transient.hpp"
#include "epc/polar/coordinates.hpp"
#include "epc/summary.hpp"
#include "problem/motion_scales.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc::polar {
namespace {

using half_plane::ClosureDensity;
using half_plane::ClosureRootSearchResult;
using transform::QuadraturePanelSpacing;

// Returns the spacing of quadrature panels: the coarse spacing if coarse panels integrate the
// density to 1 with an error below kMissed.
QuadraturePanelSpacing panels_for(const transform::SmoothDensity& density) {
  constexpr double kMissed = 1e-6;
  const double mass = transform::marginals_at_quadrature_points(
                          density, density.y_max, density.v_max, QuadraturePanelSpacing::graded)
                          .mass;
  return std::abs(mass - 1) < kMissed ? QuadraturePanelSpacing::graded
                                      : QuadraturePanelSpacing::geometric;
}

// Returns the marginal densities of the closure of order n-2, normalised on the bounding box of the
// closure density of order n.
transform::QuadratureMarginals previous_marginals(const AmplitudePhaseCoordinates& coordinates,
                                                  const ClosureDensity& previous,
                                                  const transform::SmoothDensity& density,
                                                  QuadraturePanelSpacing panels) {
  const amplitude::ExponentInPolarCoordinates q =
      amplitude::polar_exponent<AmplitudePhaseCoordinates>(previous.q);
  const double near_peak = amplitude::exponent_with_gaussian_tail(q, previous, 0, 0);
  transform::QuadratureMarginals before = transform::marginals_at_quadrature_points(
      {.value =
           [&](double y, double v) {
             const double rho = coordinates.amplitude_of(y, v), theta = coordinates.phase_of(y, v);
             return std::exp(amplitude::exponent_with_gaussian_tail(q, previous, rho, theta) -
                             near_peak);
           },
       .y_max = density.y_max,
       .v_max = density.v_max},
      density.y_max, density.v_max, panels);
  for (auto* marginal : {&before.p_y, &before.p_v}) {
    for (double& p : *marginal) p /= before.mass;
  }
  return before;
}

amplitude::CoordinateFormulation<AmplitudePhaseCoordinates> make_formulation(
    const problem::Problem& problem, const AmplitudePhaseCoordinates& coordinates,
    const ClosureOptions& options) {
  // The temperature of the closure density is the mean square velocity plus the potential energy of
  // the static deflection. Equivalent linearisation omits the energy of the static deflection.
  const problem::MotionScales scales = problem::motion_scales(problem);
  const double centre = coordinates.sqrt_twice_potential(scales.centre);
  const double temperature =
      scales.velocity_deviation * scales.velocity_deviation + centre * centre / 2;
  return {problem, coordinates, temperature, half_plane::relaxation_rate_unit(problem, temperature),
          options.tail};
}

transform::SmoothDensity density_from_exponent(const ClosureDensity& closure,
                                               const AmplitudePhaseCoordinates& coordinates,
                                               DensityTailTreatment tail) {
  return amplitude::density_from_exponent(
      closure.q, coordinates, closure.support,
      half_plane::make_exponent_confinement(closure.level, tail), -closure.log_normalisation);
}

}  // namespace

ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options) {
  const AmplitudePhaseCoordinates coordinates(problem);
  const ClosureRootSearchResult root =
      half_plane::find_closure_root(make_formulation(problem, coordinates, options), options);
  ClosureResult result = half_plane::make_unassessed_result(root);
  if (!root.failure.empty()) return result;

  const ClosureDensity& closure = root.closure;
  const transform::SmoothDensity density =
      density_from_exponent(closure, coordinates, options.tail);
  const QuadraturePanelSpacing panels = panels_for(density);
  const auto marginals = store_density(problem, ImpactCondition::map, density, result, panels);
  if (root.previous) {
    result.summary.distance_to_previous = summed_l1_distance(
        marginals, previous_marginals(coordinates, *root.previous, density, panels));
  }
  amplitude::assess_closure_root(problem, coordinates, root, options.tail, density, "the density",
                                 result);
  return result;
}

ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request) {
  const AmplitudePhaseCoordinates coordinates(problem);
  return half_plane::solve_evolution(make_formulation(problem, coordinates, options), problem,
                                     options, request, [&](const ClosureDensity& closure) {
                                       return density_from_exponent(closure, coordinates,
                                                                    options.tail);
                                     });
}

}  // namespace fpkcheck::epc::polar
