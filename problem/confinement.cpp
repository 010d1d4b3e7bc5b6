#include "problem/confinement.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"
#include "problem/energy_averaging.hpp"
#include "problem/features.hpp"

namespace fpkcheck::problem {

void require_stationary(const Problem& problem) {
  if (!problem.impulses.present() && !problem.noise.present()) {
    throw InputError(
        "nothing excites the oscillator: add [impulse] with rate, law and intensity, or [noise] "
        "with intensity");
  }
  const UndampedOrbits orbits(problem);
  for (const auto& [held, side] : {std::pair{orbits.held_on_the_left(), "left"},
                                   std::pair{orbits.held_on_the_right(), "right"}}) {
    if (held) continue;
    throw InputError(fmt::format(
        "there is no stationary density: the restoring force does not confine the mass on the {0}; "
        "change the sign of its highest power, or add wall.{0}",
        side));
  }
  // The base class needs no calculation: none of its terms supplies energy, and damping dissipates
  // it.
  if (of_the_paper(problem)) return;
  const EnergyAveraging averaging(problem);
  if (const auto& why = averaging.unconfined()) {
    throw InputError(fmt::format(
        "there is no stationary density: {}; raise system.damping, system.van_der_pol or "
        "system.rayleigh, or give a wall a restitution below 1",
        *why));
  }
}

}  // namespace fpkcheck::problem
