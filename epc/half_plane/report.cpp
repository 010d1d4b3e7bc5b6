#include "epc/half_plane/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "epc/form/allowed.hpp"
#include "epc/half_plane/search.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using transform::Status;

// Reason why a density that satisfies the equations is inadmissible; empty for an admissible one.
std::string objection_to(const transform::Solution& solution, const Summary& summary) {
  constexpr double kBeyondAllowed = 1e-3;
  if (!(std::abs(solution.mass - 1) <= kMassAllowed)) {
    return fmt::format(
        "the mass by panels over the support is {:.5f} (limits 1 +- {:.0e}): the panels do not "
        "resolve a spike of the density, nor do moments and marginals",
        solution.mass, kMassAllowed);
  }
  if (!(summary.half_plane->beyond_level <= kBeyondAllowed)) {
    return fmt::format(
        "about {:.1e} of the probability lies at or beyond the confinement level (limit {:.0e}): "
        "the confinement distorts the density",
        summary.half_plane->beyond_level, kBeyondAllowed);
  }
  return "";
}

}  // namespace

Result reported(const Root& root) {
  Result result;
  result.summary.iterations = root.newton.iterations;
  result.summary.residual = root.newton.residual;
  result.solution.status = Status::not_converged;
  result.solution.reason = root.failure;
  return result;
}

Frame frame_of(const Shape& shape, Tail tail, Variables variables) {
  return {.variables = variables,
          .log_constant = -shape.log_normalisation,
          .support = shape.support,
          .level = confinement_of(shape.level, tail).level};
}

void describe(const Root& root, Tail tail, const transform::SmoothDensity& density,
              const Deviations& sigma, const Edges& edges, Result& result) {
  const Shape& shape = root.shape;
  const auto beyond = [&](const Contour& contour) {
    return probability_beyond(shape.q, contour, shape.temperature, shape.log_normalisation);
  };
  const auto [least, greatest] = radii(edges.support, sigma);
  result.summary.condition = root.condition;
  result.summary.coefficients = shape.q.terms();
  result.summary.support = {.least_radius = least,
                            .greatest_radius = greatest,
                            .y_max = density.y_max,
                            .v_max = density.v_max,
                            .edge_density = edges.density,
                            .cut_off = beyond(edges.support),
                            .y_min = density.y_min};
  result.summary.half_plane = {.tail = tail,
                               .level = shape.level,
                               .level_deviations = std::sqrt(2 * shape.level / shape.temperature),
                               .beyond_level = beyond(edges.level),
                               .quadrature_change = root.quadrature_change,
                               .homotopies = root.homotopies};
}

void conclude(const Root& root, double quadrature_allowed, const std::string& objection,
              Result& result) {
  auto& [solution, summary] = result;
  if (!(root.quadrature_change < quadrature_allowed)) {
    solution = {};
    solution.status = Status::not_converged;
    solution.reason = fmt::format(
        "more quadrature points change Q_n by {:.1e} standard deviations (limit {:.0e}): {} x {} "
        "points do not resolve the density or the law of the impulses",
        root.quadrature_change, quadrature_allowed, root.quadrature.s, root.quadrature.t);
    return;
  }
  solution.reason = objection.empty() ? objection_to(solution, summary) : objection;
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

Deviations deviations(const transform::Moments& moments) {
  return {std::sqrt(moments.y2), std::sqrt(moments.v2)};
}

}  // namespace fpkcheck::epc::half_plane
