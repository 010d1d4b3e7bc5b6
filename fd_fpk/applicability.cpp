#include "fd_fpk/applicability.hpp"

#include "fd_fpk/characteristics/rest_points.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Returns whether the equation has a diffusion term, from white noise or from the impulses.
bool has_diffusion(const problem::ProblemFeatures& features, const Options& options) {
  return features.noise || options.equation == DensityEquation::white ||
         options.equation == DensityEquation::km4;
}

}  // namespace

std::string unsupported_reason(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  const bool noise = has_diffusion(features, options);
  // The equation km4 and the impact condition delta act like white noise at the wall. For the
  // paper's oscillator the solver accepts km4 and delta, as in the paper. Under `white` with the
  // exact impact, the discretisation reports an inelastic collapse.
  if (noise && !has_linearised_scales(problem)) {
    std::string collapse = problem::inelastic_collapse_reason(problem, DensityEquation::white);
    if (!collapse.empty()) return collapse;
  }
  if (options.impact != ImpactCondition::map &&
      (features.no_wall || features.two_walls || features.rests_in_contact)) {
    return "impact delta (first order in 1-r): requires one wall without rest in contact; use map";
  }
  // White noise ends every contact at once, so the stationary law has no atom.
  const bool rests = features.rests_in_contact && !noise;
  if (rests && !can_use_characteristics(options)) {
    return "the mass comes to rest in contact with a wall: only characteristics treat this atom; "
           "use kf and leave out transport, order, nx, nv and origin-refinement";
  }
  if (rests || options.transport == TransportScheme::characteristics) {
    return noise ? "characteristics: the motion between impulses must be deterministic; use "
                   "transport upwind"
                 : characteristics_unsupported_reason(problem);
  }
  return "";
}

std::string transient_unsupported_reason(const problem::Problem& problem, const Options& options) {
  if (std::string why = problem::polynomial_required_reason(problem); !why.empty()) return why;
  const auto features = problem::features(problem);
  if (features.rests_in_contact && !has_diffusion(features, options)) {
    return "the mass comes to rest in contact with a wall: differences do not represent this atom; "
           "compute the stationary density";
  }
  return unsupported_reason(problem, options);
}

bool can_use_characteristics(const Options& options) {
  return options.equation == DensityEquation::kf && options.impact == ImpactCondition::map &&
         options.transport != TransportScheme::upwind && !options.nx && !options.nv &&
         !options.origin_refinement && transport_order(options) == kDefaultOrder;
}

std::string characteristics_unsupported_reason(const problem::Problem& problem) {
  if (!problem.system.has_polynomial_force() || !problem.system.has_constant_restitution()) {
    return "characteristics need a polynomial force and constant restitution coefficients; use "
           "transport upwind";
  }
  const auto features = problem::features(problem);
  if (features.noise || !features.impulses) {
    return "characteristics: impulses alone must excite the oscillator; use transport upwind";
  }
  if (features.no_wall)
    return "characteristics start at walls: the problem has no wall; use transport upwind";
  if (features.negative_damping) {
    return "characteristics must end at rest points: the damping of the problem increases "
           "the energy";
  }
  const Flow flow(problem.system);
  const auto points = rest_points(flow);
  if (points.empty())
    return "characteristics must end at rest points: the problem has no rest point";
  for (const RestPoint& point : points) {
    if (!point.contact && flow.contraction_rate({point.y, 0}) <= 0) {
      return "characteristics must end at rest points: an equilibrium of the problem is undamped";
    }
  }
  return "";
}

bool has_rest_in_contact(const problem::Problem& problem, const Options& options) {
  return problem::features(problem).rests_in_contact && options.equation == DensityEquation::kf;
}

}  // namespace fpkcheck::fd_fpk
