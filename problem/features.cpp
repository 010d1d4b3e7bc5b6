#include "problem/features.hpp"

#include "problem/inelastic_collapse.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

bool of_the_paper(const Problem& problem) {
  const System& system = problem.system;
  const auto& g = system.force().coefficients();
  return system.left() && system.left()->position == 0 && !system.right() &&
         system.damping_is_constant() && system.damping() > 0 && g[0] == 0 && g[1] >= 0 &&
         g[2] == 0 && g[3] >= 0 && g[5] == 0 && g[1] + g[3] > 0 && problem.impulses.present() &&
         !problem.noise.present();
}

Features features(const Problem& problem) {
  const System& system = problem.system;
  Features found{.original = of_the_paper(problem),
                 .no_wall = !system.left() && !system.right(),
                 .two_walls = system.left() && system.right(),
                 .noise = problem.noise.present(),
                 .impulses = problem.impulses.present(),
                 .constant_damping = system.damping_is_constant()};
  const auto& c = system.coefficients();
  found.negative_damping = c.damping < 0 || c.van_der_pol < 0 || c.rayleigh < 0;
  const auto look_at = [&](const std::optional<Wall>& wall, double towards) {
    if (!wall) return;
    // The force on the mass is -g: it presses against a left wall where g > 0.
    const double pressing = -towards * system.force()(wall->position);
    if (pressing != 0) found.offset_wall = true;
    if (pressing > 0 && wall->restitution < 1 && !found.noise) found.rests_in_contact = true;
    if (found.noise && wall->restitution <= kCollapseRestitution) found.collapse = true;
  };
  look_at(system.left(), -1);
  look_at(system.right(), 1);
  if (!found.original) found.wells = static_cast<int>(UndampedOrbits(problem).minima().size());
  return found;
}

}  // namespace fpkcheck::problem
