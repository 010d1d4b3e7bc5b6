#include "epc/polar/solve.hpp"

#include <cmath>

#include "epc/amplitude/setting.hpp"
#include "epc/form/put_density.hpp"
#include "epc/half_plane/report.hpp"
#include "epc/half_plane/search.hpp"
#include "epc/polar/density.hpp"
#include "epc/polar/search.hpp"
#include "epc/polar/tail.hpp"
#include "transform/panel_marginals.hpp"

namespace fpkcheck::epc::polar {
namespace {

using half_plane::Root;
using half_plane::Shape;
using transform::Panels;

// The coarser panels, if they give the mass to kMissed.
Panels panels_for(const transform::SmoothDensity& density) {
  constexpr double kMissed = 1e-6;
  const double mass =
      transform::panel_marginals(density, density.y_max, density.v_max, Panels::graded).mass;
  return std::abs(mass - 1) < kMissed ? Panels::graded : Panels::shrinking;
}

// Marginals of C exp(Q_(n-2)) on the box of another density, normalised on this box.
transform::PanelMarginals marginals_before(const Coordinates& coordinates, const Shape& previous,
                                           const transform::SmoothDensity& density, Panels panels) {
  const amplitude::Exponent q = on_circle(previous.q);
  const double near_peak = amplitude::exponent_on_the_way(q, previous, 0, 0);
  transform::PanelMarginals before = transform::panel_marginals(
      {.value =
           [&](double y, double v) {
             const double rho = coordinates.rho(y, v), theta = coordinates.theta(y, v);
             return std::exp(amplitude::exponent_on_the_way(q, previous, rho, theta) - near_peak);
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
  const Root root = find_root(problem, coordinates, options);
  Result result = half_plane::reported(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const Shape& shape = root.shape;
  const auto confinement = half_plane::confinement_of(shape.level, options.tail);
  const transform::SmoothDensity density =
      density_of(shape.q, coordinates, shape.support, confinement, -shape.log_normalisation);
  const Panels panels = panels_for(density);
  const auto marginals = put_density(problem, Impact::map, density, result, panels);
  if (root.previous) {
    summary.distance_to_previous =
        distance(marginals, marginals_before(coordinates, *root.previous, density, panels));
  }
  const double support = amplitude::amplitude_at(shape.support);
  const double edge = std::exp(amplitude::largest_at(on_circle(shape.q), support) +
                               confinement(amplitude::energy_at(support)) - shape.peak);
  summary.leading_form =
      leading_form_in_amplitude(shape.q, half_plane::deviations(solution.moments));
  summary.frame = half_plane::frame_of(shape, options.tail, Variables::polar);
  half_plane::describe(root, options.tail, density, half_plane::deviations(solution.moments),
                       {.support = contour(coordinates, support),
                        .level = contour(coordinates, amplitude::amplitude_at(shape.level)),
                        .density = edge},
                       result);
  half_plane::conclude(root, amplitude::kQuadratureAllowed,
                       amplitude::objection("the density", root.remains, edge), result);
  return result;
}

}  // namespace fpkcheck::epc::polar
