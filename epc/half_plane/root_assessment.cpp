#include "epc/half_plane/root_assessment.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using transform::Status;

std::string common_inadmissible_reason(const ClosureRootSearchResult& root,
                                       const transform::Solution& solution,
                                       const ClosureSummary& summary) {
  // Largest growth rate of small deviations of the moments from an accepted root, in units of
  // relaxation_rate_unit(). Rounding errors cause small positive growth rates near stable roots.
  constexpr double kGrowthLimit = 1e-3;
  constexpr double kBeyondLevelLimit = 1e-3;
  if (!(std::abs(solution.mass - 1) <= kClosureMassTolerance)) {
    return fmt::format(
        "the mass by panels over the support is {:.5f} (limits 1 +- {:.0e}): the panels do not "
        "resolve a spike of the density; moments and marginal densities have the same error",
        solution.mass, kClosureMassTolerance);
  }
  if (!(summary.half_plane->beyond_level <= kBeyondLevelLimit)) {
    return fmt::format(
        "about {:.1e} of the probability lies at or beyond the confinement level (limit {:.0e}): "
        "the confinement distorts the density",
        summary.half_plane->beyond_level, kBeyondLevelLimit);
  }
  const double growth = root.rightmost_eigenvalue.real();
  if (!(growth <= kGrowthLimit * root.relaxation_rate_unit)) {
    return fmt::format(
        "the root is unstable: deviations of the moments grow at the rate {:.1e} under the moment "
        "equations, and almost all densities of this form near the root leave it",
        growth);
  }
  return "";
}

}  // namespace

ClosureResult make_unassessed_result(const ClosureRootSearchResult& root) {
  ClosureResult result;
  result.summary.iterations = root.newton.iterations;
  result.summary.residual = root.newton.residual;
  result.solution.status = Status::not_converged;
  result.solution.reason = root.failure;
  return result;
}

ClosedFormDensityParameters closed_form_parameters(const ClosureDensity& closure,
                                                   DensityTailTreatment tail,
                                                   ExponentCoordinates variables) {
  return {.variables = variables,
          .log_constant = -closure.log_normalisation,
          .support = closure.support,
          .level = make_exponent_confinement(closure.level, tail).level};
}

void store_half_plane_summary(const ClosureRootSearchResult& root, DensityTailTreatment tail,
                              const transform::SmoothDensity& density,
                              const StandardDeviations& sigma,
                              const EdgeAndConfinementLevelContours& edges, ClosureResult& result) {
  assert(result.solution.density);
  const ClosureDensity& closure = root.closure;
  const auto beyond = [&](const DensityContour& contour) {
    return probability_beyond_contour(closure.q, contour, closure.temperature,
                                      closure.log_normalisation);
  };
  const auto [least, greatest] = scaled_radius_range(edges.support, sigma);
  result.summary.condition = root.condition;
  result.summary.coefficients = closure.q.terms();
  result.summary.support = {.least_radius = least,
                            .greatest_radius = greatest,
                            .y_max = density.y_max,
                            .v_max = density.v_max,
                            .edge_density = edges.density,
                            .cut_off = beyond(edges.support),
                            .y_min = density.y_min};
  result.summary.half_plane = {
      .tail = tail,
      .level = closure.level,
      .level_deviations = std::sqrt(2 * closure.level / closure.temperature),
      .beyond_level = beyond(edges.level),
      .quadrature_change = root.quadrature_change,
      .homotopies = root.homotopies,
      .relaxation_rate = -root.rightmost_eigenvalue.real(),
      .relaxation_frequency = root.rightmost_eigenvalue.imag()};
}

void set_status(const ClosureRootSearchResult& root, double quadrature_tolerance,
                const std::string& inadmissible_reason, ClosureResult& result) {
  auto& [solution, summary] = result;
  const bool is_known_inadmissible = root.is_refinement_omitted && !inadmissible_reason.empty();
  if (!is_known_inadmissible && !(root.quadrature_change < quadrature_tolerance)) {
    solution = {};
    solution.status = Status::not_converged;
    solution.reason = fmt::format(
        "more quadrature points change Q_n by {:.1e} standard deviations (limit {:.0e}): {} x {} "
        "points do not resolve the density or the law of the impulses",
        root.quadrature_change, quadrature_tolerance, root.quadrature.s, root.quadrature.t);
    return;
  }
  solution.reason = inadmissible_reason.empty()
                        ? common_inadmissible_reason(root, solution, summary)
                        : inadmissible_reason;
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

StandardDeviations root_mean_squares(const transform::Moments& moments) {
  return {std::sqrt(moments.y2), std::sqrt(moments.v2)};
}

}  // namespace fpkcheck::epc::half_plane
