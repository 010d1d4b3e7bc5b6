#include "fd_fpk/offered.hpp"

#include "fd_fpk/characteristics/rest.hpp"
#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Noise, or what stands for the impulses has the diffusion of one.
bool diffuses(const problem::Features& features, const Options& options) {
  return features.noise || options.equation == Equation::white || options.equation == Equation::km4;
}

}  // namespace

std::string objection(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  if (features.original) return "";
  const bool noise = diffuses(features, options);
  if (noise) {
    std::string collapse = problem::collapse_objection(problem, Equation::white);
    if (!collapse.empty()) return collapse;
  }
  if (options.impact != Impact::map &&
      (features.no_wall || features.two_walls || features.rests_in_contact)) {
    return "the impact to first order in 1-r is that of the paper's closure: at one wall, where "
           "nothing comes to rest";
  }
  // White noise lifts the mass off again at once.
  const bool rests = features.rests_in_contact && !noise;
  if (rests && !may_follow_characteristics(options)) {
    return "the mass comes to rest in contact with a wall, where the law has an atom: that takes the "
           "transport along characteristics, for kf, on cells and of an order of its own";
  }
  if (rests || options.transport == Transport::characteristics) {
    return noise ? "along characteristics nothing is random between two impulses"
                 : characteristics_objection(problem);
  }
  return "";
}

std::string objection_over_time(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  if (features.rests_in_contact && !diffuses(features, options)) {
    return "the mass comes to rest in contact with a wall, where the law has an atom, which "
           "differences do not hold: take the stationary density";
  }
  return objection(problem, options);
}

bool may_follow_characteristics(const Options& options) {
  return options.equation == Equation::kf && options.impact == Impact::map &&
         options.transport != Transport::upwind && !options.nx && !options.nv &&
         !options.origin_refinement && order_of(options) == kUsualOrder;
}

std::string characteristics_objection(const problem::Problem& problem) {
  const auto features = problem::features(problem);
  if (features.noise || !features.impulses) {
    return "along characteristics nothing is random between two impulses";
  }
  if (features.no_wall) return "characteristics begin at walls";
  if (features.negative_damping) {
    return "characteristics end at rest, and this damping gives energy to the motion";
  }
  const Flow flow(problem.system);
  const auto places = rest_places(flow);
  if (places.empty()) return "characteristics end at rest, and here is no place of rest";
  for (const RestPlace& place : places) {
    if (!place.contact && flow.contraction({place.y, 0}) <= 0) {
      return "characteristics end at rest, and nothing damps the motion about an equilibrium";
    }
  }
  return "";
}

bool rests_in_contact(const problem::Problem& problem, const Options& options) {
  return problem::features(problem).rests_in_contact && options.equation == Equation::kf;
}

}  // namespace fpkcheck::fd_fpk
