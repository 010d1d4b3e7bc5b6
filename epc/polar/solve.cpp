#include "epc/polar/solve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "epc/admissibility.hpp"
#include "epc/polar/search.hpp"
#include "epc/polar/tail.hpp"
#include "epc/put_density.hpp"

namespace fpkcheck::epc::polar {
namespace {

using transform::Status;

// By how much more points may change Q_n, in standard deviations: below what the exponent's shape
// leaves at the usual orders.
constexpr double kQuadratureAllowed = 1e-3;
// Largest density where the confinement begins, relative to the peak: beyond, it would shape it.
constexpr double kLevelAllowed = 1e-4;

transform::SmoothDensity density_of(const Coordinates& coordinates, const Root& root) {
  return {.value =
              [coordinates, q = root.q, confinement = moment::Confinement{root.level},
               support = root.support, constant = root.log_normalisation](double y, double v) {
                const double rho = coordinates.rho(y, v);
                if (y < 0 || rho > support) return 0.0;
                return std::exp(q(rho, coordinates.theta(y, v)) + confined(confinement, rho) -
                                constant);
              },
          .y_max = coordinates.y(root.support),
          .v_max = root.support};
}

// C exp(Q_(n-2)) on the box of another density, C such that it integrates to 1 there.
double distance_to_previous(const Coordinates& coordinates, const Root& root,
                            const transform::PanelMarginals& marginals,
                            const transform::SmoothDensity& density) {
  const auto& q = *root.previous;
  const double near_peak = q(0, 0);
  transform::PanelMarginals before = transform::panel_marginals(
      {.value =
           [&](double y, double v) {
             return std::exp(q(coordinates.rho(y, v), coordinates.theta(y, v)) - near_peak);
           },
       .y_max = density.y_max,
       .v_max = density.v_max},
      density.y_max, density.v_max, transform::Panels::graded);
  for (auto* marginal : {&before.p_y, &before.p_v}) {
    for (double& p : *marginal) p /= before.mass;
  }
  return distance(marginals, before);
}

// @param edge largest density on the edge of the support, relative to the peak
std::string objection(const Root& root, double edge) {
  if (!(root.level_density < kLevelAllowed)) {
    return fmt::format(
        "the density is {:.1e} of its peak where its confinement begins, or beyond (allowed {:.0e})",
        root.level_density, kLevelAllowed);
  }
  if (!(edge < Support::kEdgeAllowed)) {
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (allowed {:.0e})", edge,
        Support::kEdgeAllowed);
  }
  return "";
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Coordinates coordinates(problem);
  const Root root = find_root(problem, coordinates,
                              {.order = options.order,
                               .tolerance = options.tolerance,
                               .max_iterations = options.max_iterations});
  Result result;
  auto& [solution, summary] = result;
  summary.iterations = root.newton.iterations;
  summary.residual = root.newton.residual;
  solution.status = Status::not_converged;
  solution.reason = root.failure;
  if (!root.failure.empty()) return result;

  const transform::SmoothDensity density = density_of(coordinates, root);
  const transform::PanelMarginals marginals =
      put_density(problem, problem::Impact::map, density, solution, transform::Panels::graded);
  if (root.previous) {
    summary.distance_to_previous = distance_to_previous(coordinates, root, marginals, density);
  }
  const Deviations sigma{std::sqrt(solution.moments.y2), std::sqrt(solution.moments.v2)};
  const double level = std::sqrt(2 * root.level);
  const double beyond =
      probability_beyond(root.q, coordinates, level, root.temperature, root.log_normalisation);
  const auto [least, greatest] = radii(coordinates, root.support, sigma);
  const double edge = std::exp(largest_at(root.q, root.support) +
                               confined(moment::Confinement{root.level}, root.support) - root.peak);
  summary.condition = root.condition;
  summary.coefficients = root.q.terms();
  summary.leading_form = polar::leading_form(root.q, sigma);
  summary.support = {.least_radius = least,
                     .greatest_radius = greatest,
                     .y_max = density.y_max,
                     .v_max = density.v_max,
                     .edge_density = edge,
                     .cut_off = probability_beyond(root.q, coordinates, root.support,
                                                   root.temperature, root.log_normalisation)};
  summary.moment = {.tail = moment::Tail::confined,
                    .level = root.level,
                    .level_deviations = std::sqrt(2 * root.level / root.temperature),
                    .beyond_level = beyond,
                    .quadrature_change = root.quadrature_change,
                    .homotopies = root.homotopies};
  if (!(root.quadrature_change < kQuadratureAllowed)) {
    solution = {.method = {}, .equation = {}, .status = Status::not_converged};
    solution.reason = fmt::format(
        "half as many more points of the quadrature still changed Q_n by {:.1e} of a unit (allowed "
        "{:.0e}): the density or the law of the impulses has features that {} x {} points miss",
        root.quadrature_change, kQuadratureAllowed, root.quadrature.rho, root.quadrature.theta);
    return result;
  }
  solution.reason = objection(root, edge);
  if (solution.reason.empty()) {
    solution.reason = half_plane_objection(options.order, solution, summary);
  }
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  return result;
}

}  // namespace fpkcheck::epc::polar
