#include "epc/contact/solve.hpp"

#include <cmath>
#include <variant>

#include "epc/amplitude/setting.hpp"
#include "epc/contact/density.hpp"
#include "epc/contact/observed.hpp"
#include "epc/contact/search.hpp"
#include "epc/contact/tail.hpp"
#include "epc/half_plane/report.hpp"
#include "epc/half_plane/search.hpp"

namespace fpkcheck::epc::contact {
namespace {

using half_plane::Root;
using half_plane::Shape;
using transform::GridDensity;

// Sum of the L1 distances of both marginals; both densities have the same cells.
double distance(const GridDensity& a, const GridDensity& b) {
  std::vector<double> of_y(a.ny()), of_v(a.nv());
  for (std::size_t i = 0; i < a.ny(); ++i) {
    for (std::size_t j = 0; j < a.nv(); ++j) {
      const double area = (a.y_edges[i + 1] - a.y_edges[i]) * (a.v_edges[j + 1] - a.v_edges[j]);
      const double difference = area * (a.average(i, j) - b.average(i, j));
      of_y[i] += difference;
      of_v[j] += difference;
    }
  }
  double sum = 0;
  for (const auto* marginal : {&of_y, &of_v}) {
    for (const double difference : *marginal) sum += std::abs(difference);
  }
  return sum;
}

double probability_at_rest(const Coordinates& coordinates, const Shape& shape) {
  return coordinates.atom_weight() * std::exp(shape.q(0, 0) - shape.log_normalisation);
}

// Distance to the root of order n - 2, on the cells of the solution, with that of the atoms.
double distance_to(const Coordinates& coordinates, const Shape& previous, Tail tail,
                   const transform::Solution& solution) {
  const auto& cells = std::get<GridDensity>(*solution.density);
  const GridDensity before = transform::on_cells(
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
  Result result = half_plane::reported(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const Shape& shape = root.shape;
  const auto confinement = half_plane::confinement_of(shape.level, options.tail);
  const transform::SmoothDensity density =
      density_of(shape.q, coordinates, shape.support, confinement, -shape.log_normalisation);
  put_density_and_atom(problem, coordinates, root, density, result);
  if (root.previous) {
    summary.distance_to_previous = distance_to(coordinates, *root.previous, options.tail, solution);
  }
  const Deviations sigma = half_plane::deviations(summary.moments);
  summary.leading_form = leading_form_of(shape.q, sigma);
  summary.frame = half_plane::frame_of(shape, options.tail, Variables::contact);
  summary.frame->coordinates = problem.frame;
  const double support = amplitude::amplitude_at(shape.support);
  const double edge = std::exp(amplitude::largest_at(on_circle(shape.q), support) +
                               confinement(shape.support) - shape.peak);
  half_plane::describe(root, options.tail, density, sigma,
                       {.support = contour(coordinates, support),
                        .level = contour(coordinates, amplitude::amplitude_at(shape.level)),
                        .density = edge},
                       result);
  half_plane::conclude(root, amplitude::kQuadratureAllowed,
                       amplitude::objection("exp(Q_n)", root.remains, edge), result);
  return result;
}

}  // namespace fpkcheck::epc::contact
