#include "backward/residual/applicability.hpp"

#include "problem/features.hpp"

namespace fpkcheck::backward {

std::string residuals_unsupported_reason(const problem::Problem& problem) {
  const problem::ProblemFeatures features = problem::features(problem);
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall: residuals of a density do not contain the atom";
  }
  if (features.collapse) {
    return "impacts accumulate at a wall (r <= 0.163 under noise): the impact law does not define "
           "how the mass leaves the wall";
  }
  return {};
}

}  // namespace fpkcheck::backward
