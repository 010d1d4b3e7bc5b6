#include "epc/polar/solve.hpp"

#include <cmath>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/form/store_density.hpp"
#include "epc/half_plane/result_from_root.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/polar/contour.hpp"
#include "epc/polar/density.hpp"
#include "epc/polar/root_search.hpp"
#include "transform/panel_marginals.hpp"

namespace fpkcheck::epc::polar {
namespace {

using half_plane::ClosureDensity;
using half_plane::RootSearchResult;
using transform::PanelSpacing;

// Spacing of the panels: the coarser panels, if the error of their total probability is below
// kMissed, else the finer panels.
PanelSpacing panels_for(const transform::SmoothDensity& density) {
  constexpr double kMissed = 1e-6;
  const double mass =
      transform::panel_marginals(density, density.y_max, density.v_max, PanelSpacing::graded).mass;
  return std::abs(mass - 1) < kMissed ? PanelSpacing::graded : PanelSpacing::geometric;
}

// Marginal densities of C exp(Q_(n-2)) on the box of another density, normalised on this box.
transform::PanelMarginals previous_marginals(const Coordinates& coordinates,
                                             const ClosureDensity& previous,
                                             const transform::SmoothDensity& density,
                                             PanelSpacing panels) {
  const amplitude::PolarExponent q = polar_exponent(previous.q);
  const double near_peak = amplitude::exponent_with_gaussian_tail(q, previous, 0, 0);
  transform::PanelMarginals before = transform::panel_marginals(
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

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Coordinates coordinates(problem);
  const RootSearchResult root = find_root(problem, coordinates, options);
  Result result = half_plane::make_unassessed_result(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const ClosureDensity& closure = root.closure;
  const auto confinement = half_plane::confinement_of(closure.level, options.tail);
  const transform::SmoothDensity density = density_from_exponent(
      closure.q, coordinates, closure.support, confinement, -closure.log_normalisation);
  const PanelSpacing panels = panels_for(density);
  const auto marginals = store_density(problem, Impact::map, density, result, panels);
  if (root.previous) {
    summary.distance_to_previous =
        distance(marginals, previous_marginals(coordinates, *root.previous, density, panels));
  }
  const double support = amplitude::amplitude_of_energy(closure.support);
  const double edge = std::exp(amplitude::maximum_over_phase(polar_exponent(closure.q), support) +
                               confinement(amplitude::energy_of_amplitude(support)) - closure.peak);
  summary.leading_form =
      leading_form_in_amplitude(closure.q, half_plane::root_mean_squares(solution.moments));
  summary.frame =
      half_plane::closed_form_parameters(closure, options.tail, ExponentCoordinates::polar);
  half_plane::store_half_plane_summary(
      root, options.tail, density, half_plane::root_mean_squares(solution.moments),
      {.support = contour_of_amplitude(coordinates, support),
       .level = contour_of_amplitude(coordinates, amplitude::amplitude_of_energy(closure.level)),
       .density = edge},
      result);
  half_plane::set_status(root, amplitude::kQuadratureTolerance,
                         amplitude::inadmissible_reason("the density", root.decay_ratio, edge),
                         result);
  return result;
}

}  // namespace fpkcheck::epc::polar
