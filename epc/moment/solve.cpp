#include <fmt/format.h>

#include <cmath>
#include <string>

#include "epc/formulations.hpp"
#include "epc/half_plane/root_assessment.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/half_plane/transient.hpp"
#include "epc/moment/density.hpp"
#include "epc/moment/root_search.hpp"
#include "epc/summary.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc::moment {
namespace {

using half_plane::ClosureDensity;
using half_plane::ClosureRootSearchResult;

// Largest accepted change of the exponent Q_n when quadrature points are added, in standard
// deviations under the density.
constexpr double kQuadratureTolerance = 1e-6;

transform::SmoothDensity density_from_exponent(const problem::Problem& problem,
                                               const ClosureDensity& closure,
                                               DensityTailTreatment tail) {
  return density_from_exponent(closure.q, EnergySublevelSet(problem, closure.support),
                               half_plane::make_exponent_confinement(closure.level, tail),
                               -closure.log_normalisation);
}

// Returns the reason why a closure density is inadmissible: it has not decayed on the edge of its
// support, or decays by the confinement term alone.
std::string inadmissible_reason(double edge_density, double density_at_level,
                                const ExponentBehaviourAtInfinity& form) {
  const std::string behaviour = describe_exponent_at_infinity(form, "(y, v) / deviations");
  if (!(edge_density < kMaxSupportEdgeDensity)) {
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (limit {:.0e}), {}",
        edge_density, kMaxSupportEdgeDensity, behaviour);
  }
  if (!(density_at_level < kLevelDensityLimit)) {
    return fmt::format("exp(Q_n) is {:.1e} of its peak at the confinement level (limit {:.0e}), {}",
                       density_at_level, kLevelDensityLimit, behaviour);
  }
  return "";
}

}  // namespace

ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options) {
  const ClosureRootSearchResult root = find_closure_root(problem, options);
  ClosureResult result = half_plane::make_unassessed_result(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const ClosureDensity& closure = root.closure;
  const transform::SmoothDensity density = density_from_exponent(problem, closure, options.tail);
  const auto marginals = store_density(problem, ImpactCondition::map, density, result);
  if (root.previous) {
    auto before = density_from_exponent(problem, *root.previous, options.tail);
    // Equal values of y_min give the densities of closure orders n and n-2 equal quadrature panels
    before.y_min = density.y_min;
    summary.distance_to_previous = summed_l1_distance(
        marginals, transform::marginals_at_quadrature_points(before, density.y_max, density.v_max));
  }
  const StandardDeviations sigma = half_plane::root_mean_squares(marginals.moments);
  summary.leading_form = leading_form(closure.q, sigma,
                                      problem.system.left_wall() ? PhasePlaneDirectionRange::half
                                                                 : PhasePlaneDirectionRange::whole);
  summary.frame =
      half_plane::closed_form_parameters(closure, options.tail, ExponentCoordinates::physical);
  summary.frame->coordinates = problem.frame;
  const double edge = density_ratio_at_edge(closure, problem, options.tail);
  half_plane::store_half_plane_summary(
      root, options.tail, density, sigma,
      {.support = energy_contour_of_domain_edge(EnergySublevelSet(problem, closure.support)),
       .level = energy_contour_of_domain_edge(EnergySublevelSet(problem, closure.level)),
       .density = edge},
      result);
  half_plane::set_status(
      root, kQuadratureTolerance,
      inadmissible_reason(edge, density_ratio_at_confinement_level(closure, problem),
                          *summary.leading_form),
      result);
  return result;
}

ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request) {
  return half_plane::solve_evolution(*make_formulation(problem, options), problem, options, request,
                                     [&](const ClosureDensity& closure) {
                                       return density_from_exponent(problem, closure, options.tail);
                                     });
}

}  // namespace fpkcheck::epc::moment
