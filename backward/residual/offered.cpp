#include "backward/residual/offered.hpp"

#include "problem/features.hpp"

namespace fpkcheck::backward {

std::string residuals_refused(const problem::Problem& problem) {
  const problem::Features features = problem::features(problem);
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall, where its law has an atom that no density shows";
  }
  if (features.collapse) {
    return "impacts accumulate at a wall (r <= 0.163 under noise): the impact does not say how the "
           "mass leaves it";
  }
  return {};
}

}  // namespace fpkcheck::backward
