#include "epc/moment/solve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "epc/form/acceptance_limits.hpp"
#include "epc/form/fill_density.hpp"
#include "epc/half_plane/root_result.hpp"
#include "epc/half_plane/search.hpp"
#include "epc/moment/density.hpp"
#include "epc/moment/level_density.hpp"
#include "epc/moment/search.hpp"
#include "epc/moment/tail.hpp"
#include "problem/features.hpp"
#include "transform/panel_marginals.hpp"

namespace fpkcheck::epc::moment {
namespace {

using half_plane::ClosureDensity;
using half_plane::Root;

// Tolerance on the change of Q_n on more quadrature points, in standard deviations.
constexpr double kQuadratureTolerance = 1e-6;

transform::SmoothDensity density_of(const problem::Problem& problem, const ClosureDensity& closure,
                                    Tail tail) {
  return density_of(closure.q, EnergyDomain(problem, closure.support),
                    half_plane::confinement_of(closure.level, tail), -closure.log_normalisation);
}

// Reason why a density beyond the paper's class is inadmissible: the density decays by the
// confinement alone. The reason is empty for an admissible density.
std::string level_inadmissible_reason(double level_density, const LeadingForm& form) {
  if (level_density < kLevelDensityLimit) return "";
  return fmt::format("exp(Q_n) is {:.1e} of its peak at the confinement level (limit {:.0e}), {}",
                     level_density, kLevelDensityLimit,
                     leading_form_text(form, "(y, v) / deviations"));
}

std::string inadmissible_reason(double edge_density, const LeadingForm& form) {
  if (edge_density < kEdgeDensityLimit) return "";
  return fmt::format(
      "the density is {:.1e} of its peak on the edge of its support (limit {:.0e}), {}",
      edge_density, kEdgeDensityLimit, leading_form_text(form, "(y, v) / deviations"));
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Root root = find_root(problem, options);
  Result result = half_plane::make_result(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const ClosureDensity& closure = root.closure;
  const transform::SmoothDensity density = density_of(problem, closure, options.tail);
  const auto marginals = fill_density(problem, Impact::map, density, result);
  if (root.previous) {
    auto before = density_of(problem, *root.previous, options.tail);
    before.y_min = density.y_min;  // same panels
    summary.distance_to_previous =
        distance(marginals, transform::panel_marginals(before, density.y_max, density.v_max));
  }
  const Deviations sigma = half_plane::deviations(marginals.moments);
  summary.leading_form =
      leading_form(closure.q, sigma, problem.system.left() ? Plane::half : Plane::whole);
  summary.frame = half_plane::frame_of(closure, options.tail, Variables::physical);
  summary.frame->coordinates = problem.frame;
  const double edge = edge_density(closure, problem, options.tail);
  std::string reason = inadmissible_reason(edge, *summary.leading_form);
  // In the paper's class half_plane::set_status limits the probability beyond the level instead.
  if (reason.empty() && !problem::is_paper_oscillator(problem)) {
    reason = level_inadmissible_reason(level_density(closure, problem), *summary.leading_form);
  }
  half_plane::fill_summary(root, options.tail, density, sigma,
                           {.support = contour(EnergyDomain(problem, closure.support)),
                            .level = contour(EnergyDomain(problem, closure.level)),
                            .density = edge},
                           result);
  half_plane::set_status(root, kQuadratureTolerance, reason, result);
  return result;
}

}  // namespace fpkcheck::epc::moment
