#include "epc/contact/solve.hpp"

#include <cmath>
#include <variant>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/contact/density.hpp"
#include "epc/contact/fill_density.hpp"
#include "epc/contact/search.hpp"
#include "epc/contact/tail.hpp"
#include "epc/half_plane/root_result.hpp"
#include "epc/half_plane/search.hpp"

namespace fpkcheck::epc::contact {
namespace {

using half_plane::ClosureDensity;
using half_plane::Root;
using transform::GridDensity;

// Sum of the L1 distances of p(y) and p(v) between two densities on the same cells.
double distance(const GridDensity& a, const GridDensity& b) {
  std::vector<double> y_difference(a.ny()), v_difference(a.nv());
  for (std::size_t i = 0; i < a.ny(); ++i) {
    for (std::size_t j = 0; j < a.nv(); ++j) {
      const double area = (a.y_edges[i + 1] - a.y_edges[i]) * (a.v_edges[j + 1] - a.v_edges[j]);
      const double difference = area * (a.average(i, j) - b.average(i, j));
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

double probability_at_rest(const Coordinates& coordinates, const ClosureDensity& closure) {
  return coordinates.atom_weight() * std::exp(closure.q(0, 0) - closure.log_normalisation);
}

// Distance of a solution to the root of order n - 2: L1 distances on the cells of the solution,
// plus the difference of the atoms in both marginal distributions.
double distance_to(const Coordinates& coordinates, const ClosureDensity& previous, Tail tail,
                   const transform::Solution& solution) {
  const auto& cells = std::get<GridDensity>(*solution.density);
  const GridDensity before = transform::average_over_cells(
      density_of(previous.q, coordinates, previous.support,
                 half_plane::confinement_of(previous.level, tail), -previous.log_normalisation),
      cells.y_edges, cells.v_edges);
  const double atoms =
      std::abs(probability_at_rest(coordinates, previous) - solution.atoms[0].probability);
  return distance(cells, before) + 2 * atoms;
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Coordinates coordinates(problem);
  const Root root = find_root(problem, coordinates, options);
  Result result = half_plane::make_result(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const ClosureDensity& closure = root.closure;
  const auto confinement = half_plane::confinement_of(closure.level, options.tail);
  const transform::SmoothDensity density =
      density_of(closure.q, coordinates, closure.support, confinement, -closure.log_normalisation);
  fill_density_and_atom(problem, coordinates, root, density, result);
  if (root.previous) {
    summary.distance_to_previous = distance_to(coordinates, *root.previous, options.tail, solution);
  }
  const Deviations sigma = half_plane::deviations(summary.moments);
  summary.leading_form = leading_form_of(closure.q, sigma);
  summary.frame = half_plane::frame_of(closure, options.tail, Variables::contact);
  summary.frame->coordinates = problem.frame;
  const double support = amplitude::amplitude_at(closure.support);
  const double edge = std::exp(amplitude::maximum_over_phase(polar_exponent(closure.q), support) +
                               confinement(closure.support) - closure.peak);
  half_plane::fill_summary(root, options.tail, density, sigma,
                           {.support = contour(coordinates, support),
                            .level = contour(coordinates, amplitude::amplitude_at(closure.level)),
                            .density = edge},
                           result);
  half_plane::set_status(root, amplitude::kQuadratureTolerance,
                         amplitude::inadmissible_reason("exp(Q_n)", root.decay_ratio, edge),
                         result);
  return result;
}

}  // namespace fpkcheck::epc::contact
