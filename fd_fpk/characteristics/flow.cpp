#include "fd_fpk/characteristics/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fd_fpk/operator/turning_point.hpp"

namespace fpkcheck::fd_fpk {

Flow::Flow(const problem::System& system)
    : damping_(system.damping()),
      restitution_(system.restitution()),
      force_(system.force()),
      tangent_(system.tangent_stiffness()),
      potential_(system.potential()),
      system_(system) {}

State Flow::after(const State& from, double time) const {
  const double half = time / 2;
  const State a{from.v, acceleration(from)};
  const State at_b{from.y + half * a.y, from.v + half * a.v};
  const State b{at_b.v, acceleration(at_b)};
  const State at_c{from.y + half * b.y, from.v + half * b.v};
  const State c{at_c.v, acceleration(at_c)};
  const State at_d{from.y + time * c.y, from.v + time * c.v};
  const State d{at_d.v, acceleration(at_d)};
  return {from.y + time / 6 * (a.y + 2 * b.y + 2 * c.y + d.y),
          from.v + time / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
}

double Flow::longest_step(const State& from, double frequency) const {
  constexpr double kChange = 0.1;      // of the state, in the norm of the energy
  constexpr double kStability = 0.75;  // of 2.78 on the negative axis, where it decays as it should
  const double size = std::hypot(frequency * from.y, from.v);
  const double rate = std::hypot(frequency * from.v, acceleration(from));
  return std::min(kChange * size / rate, kStability / damping_);
}

double Flow::energy(const State& at) const { return at.v * at.v / 2 + potential_(at.y); }

double Flow::frequency(const State& at) const {
  return std::sqrt(tangent_(turning_point(system_, energy(at))));
}

Winding Flow::winding(double speed) const {
  constexpr double kCreeping = 1e-6;
  State state{0, speed};
  Winding winding{.height = 0, .duration = std::numeric_limits<double>::infinity()};
  double time = 0;
  for (double frequency = this->frequency(state); energy(state) > kCreeping * speed * speed;) {
    const double span = longest_step(state, frequency);
    const State end = after(state, span);
    if (state.v > 0 && end.v <= 0) {
      // The parabola's top.
      const double until = span * state.v / (state.v - end.v);
      winding.height = after(state, until).y;
    }
    if (end.y < 0) {
      const double until = impact_time(state, span);
      winding.landing = -after(state, until).v;
      winding.duration = time + until;
      break;
    }
    time += span;
    state = end;
  }
  return winding;
}

double Flow::impact_time(const State& from, double time) const {
  double before = 0, beyond = time;
  // Where the chord meets the wall; a flight from the wall itself has none.
  double guess = from.y > 0 ? time * from.y / (from.y - after(from, time).y) : time / 2;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const State at = after(from, guess);
    (at.y < 0 ? beyond : before) = guess;
    double next = guess - at.y / at.v;
    if (!(next > before && next < beyond)) next = (before + beyond) / 2;
    const bool close = std::abs(next - guess) <= 1e-13 * time;
    guess = next;
    if (close) break;
  }
  return guess;
}

}  // namespace fpkcheck::fd_fpk
