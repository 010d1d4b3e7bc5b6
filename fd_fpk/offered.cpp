#include "fd_fpk/offered.hpp"

#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::fd_fpk {
namespace {

bool accumulates(const std::optional<problem::Wall>& wall) {
  return wall && wall->restitution <= problem::kCollapseRestitution;
}

}  // namespace

std::string objection(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  if (features.original) return "";
  const problem::System& system = problem.system;
  const bool noise =
      features.noise || options.equation == Equation::white || options.equation == Equation::km4;
  if (noise && (accumulates(system.left()) || accumulates(system.right()))) {
    return "under white noise impacts with such a restitution accumulate, and nothing says how the "
           "motion leaves the wall";
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
