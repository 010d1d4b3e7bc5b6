#include "problem/confinement.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"
#include "problem/energy_averaging.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::problem {

void require_stationary_density(const Problem& problem) {
  if (!problem.impulses.is_present() && !problem.noise.is_present()) {
    throw InputError(
        "nothing excites the oscillator: add [impulse] with rate, law and intensity, or [noise] "
        "with intensity");
  }
  const UndampedOrbits orbits(problem);
  for (const auto& [held, side] : {std::pair{orbits.is_confining_on_left(), "left"},
                                   std::pair{orbits.is_confining_on_right(), "right"}}) {
    if (held) continue;
    throw InputError(fmt::format(
        "there is no stationary density: the restoring force does not confine the mass on the {0}; "
        "change the sign of its highest power, or add wall.{0}",
        side));
  }
  // A hardening spring with constant damping needs no calculation: no term supplies energy except
  // the impulses, and the damping dissipates energy.
  if (has_equivalent_linearisation(problem)) return;
  const EnergyAveraging averaging(problem);
  if (const auto& why = averaging.unconfined_reason()) {
    throw InputError(fmt::format(
        "there is no stationary density: {}; raise system.damping, system.van_der_pol or "
        "system.rayleigh, or give a wall a restitution below 1",
        *why));
  }
}

}  // namespace fpkcheck::problem
