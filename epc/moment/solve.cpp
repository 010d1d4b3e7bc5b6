#include "epc/moment/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "epc/admissibility.hpp"
#include "epc/moment/search.hpp"
#include "epc/moment/tail.hpp"
#include "epc/put_density.hpp"

namespace fpkcheck::epc::moment {
namespace {

using transform::Status;

// By how much more points may change Q_n, in standard deviations.
constexpr double kQuadratureAllowed = 1e-6;

// lambda E[Y^j], j = 0 .. n, as far as the equation has the term.
std::vector<double> rate_moments(const problem::Problem& problem, const Options& options) {
  std::vector<double> moments(options.order + 1);
  const int last = options.equation == Equation::white ? 2 : options.order;
  for (int j = 1; j <= last; ++j) moments[j] = problem.impulses.rate_moment(j);
  return moments;
}

transform::SmoothDensity density_of(const problem::Problem& problem, const Shape& shape,
                                    Tail tail) {
  const EnergyDomain domain(problem, shape.support);
  const Confinement confinement = tail == Tail::confined ? Confinement{shape.level} : Confinement{};
  return {.value =
              [domain, confinement, q = shape.q, constant = shape.log_normalisation](double y,
                                                                                     double v) {
                if (!domain.contains(y, v)) return 0.0;
                return std::exp(q(y, v) + confinement(domain.energy(y, v)) - constant);
              },
          .y_max = domain.y_max(),
          .v_max = domain.v_max()};
}

// What the density's own deviations make of the support.
SupportSummary support_of(const problem::Problem& problem, const Root& root,
                          const Deviations& sigma) {
  const EnergyDomain domain(problem, root.shape.support);
  const auto [least, greatest] = radii(domain, sigma);
  return {.least_radius = least,
          .greatest_radius = greatest,
          .y_max = domain.y_max(),
          .v_max = domain.v_max(),
          .edge_density = root.edge_density,
          .cut_off = probability_beyond(root.shape.q, problem, root.shape.support,
                                        root.shape.temperature, root.shape.log_normalisation)};
}

std::string objection(const Root& root, const LeadingForm& form) {
  if (root.edge_density < Support::kEdgeAllowed) return "";
  const std::string rise =
      form.negative
          ? std::string("though Q_n falls in the end")
          : fmt::format(
                "and Q_n rises in the end along {:.0f} % of all directions, along (y, v) / "
                "deviations = ({:.2f}, {:.2f}) from radius {:.2f} on",
                100 * form.rising_share, form.worst.x1, form.worst.x2, form.rises_from);
  return fmt::format(
      "the density is {:.1e} of its peak on the edge of its support (allowed {:.0e}), {}",
      root.edge_density, Support::kEdgeAllowed, rise);
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Root root = find_root(problem, {.order = options.order,
                                        .rate_moment = rate_moments(problem, options),
                                        .tail = options.tail,
                                        .tolerance = options.tolerance,
                                        .max_iterations = options.max_iterations,
                                        .edge_allowed = Support::kEdgeAllowed});
  Result result;
  auto& [solution, summary] = result;
  summary.iterations = root.newton.iterations;
  summary.residual = root.newton.residual;
  solution.status = Status::not_converged;
  solution.reason = root.failure;
  if (!root.failure.empty()) return result;

  const Shape& shape = root.shape;
  const transform::SmoothDensity density = density_of(problem, shape, options.tail);
  const transform::PanelMarginals marginals =
      put_density(problem, problem::Impact::map, density, solution);
  if (root.previous) {
    const auto before = density_of(problem, *root.previous, options.tail);
    summary.distance_to_previous =
        distance(marginals, transform::panel_marginals(before, density.y_max, density.v_max));
  }
  const Deviations sigma{std::sqrt(solution.moments.y2), std::sqrt(solution.moments.v2)};
  summary.condition = root.condition;
  summary.coefficients = shape.q.terms();
  summary.leading_form = leading_form(shape.q, sigma, Plane::half);
  summary.support = support_of(problem, root, sigma);
  summary.moment = {.tail = options.tail,
                    .level = shape.level,
                    .level_deviations = std::sqrt(2 * shape.level / shape.temperature),
                    .beyond_level = probability_beyond(shape.q, problem, shape.level,
                                                       shape.temperature, shape.log_normalisation),
                    .quadrature_change = root.quadrature_change,
                    .homotopies = root.homotopies};
  if (!(root.quadrature_change < kQuadratureAllowed)) {
    solution = {.method = {}, .equation = {}, .status = Status::not_converged};
    solution.reason = fmt::format(
        "more points of the quadrature would change Q_n by {:.1e} of a unit (allowed {:.0e}): "
        "the density has features that {} x {} points miss",
        root.quadrature_change, kQuadratureAllowed, root.quadrature.y, root.quadrature.v);
    return result;
  }
  solution.reason = objection(root, *summary.leading_form);
  if (solution.reason.empty())
    solution.reason = half_plane_objection(options.order, solution, summary);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  return result;
}

}  // namespace fpkcheck::epc::moment
