#include <cmath>
#include <variant>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/contact/store_density.hpp"
#include "epc/formulations.hpp"
#include "epc/half_plane/newton.hpp"
#include "epc/half_plane/root_assessment.hpp"
#include "epc/half_plane/root_search.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::epc::contact {
namespace {

using half_plane::ClosureDensity;
using half_plane::ClosureRootSearchResult;
using transform::GridDensity;

double marginal_l1_distance(const GridDensity& a, const GridDensity& b) {
  std::vector<double> y_difference(a.y_cell_count()), v_difference(a.v_cell_count());
  for (std::size_t i = 0; i < a.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < a.v_cell_count(); ++j) {
      const double area = (a.y_edges[i + 1] - a.y_edges[i]) * (a.v_edges[j + 1] - a.v_edges[j]);
      const double difference = area * (a.cell_average(i, j) - b.cell_average(i, j));
      y_difference[i] += difference;
      v_difference[j] += difference;
    }
  }
  double sum = 0;
  for (const auto* marginal : {&y_difference, &v_difference}) {
    for (const double difference : *marginal) sum += std::abs(difference);
  }
  return sum;
}

double probability_at_rest(const AmplitudeVelocityCoordinates& coordinates,
                           const ClosureDensity& closure) {
  return coordinates.relative_atom_probability() *
         std::exp(closure.q(0, 0) - closure.log_normalisation);
}

// Returns the distance of a closure density from the closure density of order n - 2: The distance
// is the sum of the L1 distances over the cells and of the difference between the atoms at rest in
// each of the two marginal distributions.
double distance_to_previous_order(const AmplitudeVelocityCoordinates& coordinates,
                                  const ClosureDensity& previous, DensityTailTreatment tail,
                                  const transform::Solution& solution) {
  const auto& cells = std::get<GridDensity>(*solution.density);
  const GridDensity before = transform::average_over_cells(
      amplitude::density_from_exponent(previous.q, coordinates, previous.support,
                                       half_plane::make_exponent_confinement(previous.level, tail),
                                       -previous.log_normalisation),
      cells.y_edges, cells.v_edges);
  const double atoms =
      std::abs(probability_at_rest(coordinates, previous) - solution.atoms[0].probability);
  return marginal_l1_distance(cells, before) + 2 * atoms;
}

}  // namespace

ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options) {
  const AmplitudeVelocityCoordinates coordinates(problem);
  const double deviation = problem::motion_scales(problem).velocity_deviation;
  const double temperature = deviation * deviation;
  const ClosureRootSearchResult root = half_plane::find_closure_root(
      amplitude::CoordinateFormulation(problem, coordinates, temperature,
                                       half_plane::relaxation_rate_unit(problem, temperature),
                                       options.tail),
      options);
  ClosureResult result = half_plane::make_unassessed_result(root);
  if (!root.failure.empty()) return result;

  const ClosureDensity& closure = root.closure;
  const transform::SmoothDensity density = amplitude::density_from_exponent(
      closure.q, coordinates, closure.support,
      half_plane::make_exponent_confinement(closure.level, options.tail),
      -closure.log_normalisation);
  store_density_and_atom(problem, coordinates, root, density, result);
  if (root.previous) {
    result.summary.distance_to_previous =
        distance_to_previous_order(coordinates, *root.previous, options.tail, result.solution);
  }
  amplitude::assess_closure_root(problem, coordinates, root, options.tail, density, "exp(Q_n)",
                                 result);
  return result;
}

}  // namespace fpkcheck::epc::contact
