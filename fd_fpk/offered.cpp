#include "fd_fpk/offered.hpp"

#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::fd_fpk {

std::string objection(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  if (features.original) return "";
  const bool noise =
      features.noise || options.equation == Equation::white || options.equation == Equation::km4;
  if (noise) {  // that of the cut series is its diffusion
    std::string collapse = problem::collapse_objection(problem, Equation::white);
    if (!collapse.empty()) return collapse;
  }
  if (options.impact != Impact::map) {
    return "the impact to first order in 1-r is the paper's, at one wall at the equilibrium";
  }
  if (options.transport == Transport::characteristics) {
    return "the transport along characteristics is that of one wall at the equilibrium";
  }
  // White noise lifts the mass off again at once.
  if (features.rests_in_contact && !noise) {
    return "the mass comes to rest in contact with a wall, where the law has an atom";
  }
  return "";
}

}  // namespace fpkcheck::fd_fpk
