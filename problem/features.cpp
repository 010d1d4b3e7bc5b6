#include "problem/features.hpp"

#include "problem/equivalent_linearisation.hpp"
#include "problem/inelastic_collapse.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

bool is_paper_oscillator(const Problem& problem) { return has_equivalent_linearisation(problem); }

ProblemFeatures features(const Problem& problem) {
  const System& system = problem.system;
  ProblemFeatures result{.is_paper_oscillator = is_paper_oscillator(problem),
                         .no_wall = !system.left_wall() && !system.right_wall(),
                         .two_walls = system.left_wall() && system.right_wall(),
                         .noise = problem.noise.is_present(),
                         .impulses = problem.impulses.is_present(),
                         .constant_damping = system.has_constant_damping()};
  const auto& c = system.coefficients();
  result.negative_damping = c.damping < 0 || c.van_der_pol < 0 || c.rayleigh < 0;
  const auto inspect_wall = [&](const std::optional<Wall>& wall, double towards) {
    if (!wall) return;
    // The force on the mass is -g. This force presses the mass against a left wall if g > 0 at the
    // wall.
    const double pressing = -towards * system.restoring_force()(wall->position);
    if (pressing != 0) result.offset_wall = true;
    if (pressing > 0 && wall->restitution < 1 && !result.noise) result.rests_in_contact = true;
    if (result.noise && wall->restitution <= kCollapseRestitution) result.collapse = true;
  };
  inspect_wall(system.left_wall(), -1);
  inspect_wall(system.right_wall(), 1);
  if (!result.is_paper_oscillator)
    result.wells = static_cast<int>(UndampedOrbits(problem).minima().size());
  return result;
}

}  // namespace fpkcheck::problem
