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

namespace {

// Damping times the longest step of the Runge-Kutta method: of 2.78 on the negative axis, where it
// decays as it should.
constexpr double kStability = 0.75;

// expm1(s t)/s
double grown(double s, double time) { return s == 0 ? time : std::expm1(s * time) / s; }

}  // namespace

// Exactly, with the force linear in y - y0: exponentials of the roots s of s^2 + c s + g'(y0) = 0,
// real where a step is longer than explicit formulas stand.
State Flow::after_creeping(const State& from, double time) const {
  const auto [slow, fast, v_slow, v_fast] = modes(from);
  return {from.y + v_slow * grown(slow, time) + v_fast * grown(fast, time),
          v_slow * std::exp(slow * time) + v_fast * std::exp(fast * time)};
}

Flow::Modes Flow::modes(const State& at) const {
  const double root = std::sqrt(std::max(0.0, damping_ * damping_ - 4 * tangent_(at.y)));
  const double fast = -(damping_ + root) / 2, slow = -2 * tangent_(at.y) / (damping_ + root);
  const double v_fast = (acceleration(at) - slow * at.v) / (fast - slow);
  return {.slow = slow, .fast = fast, .v_slow = at.v - v_fast, .v_fast = v_fast};
}

State Flow::after(const State& from, double time) const {
  if (damping_ * time > kStability) {
    const State full = after_creeping(from, time);
    const State halves = after_creeping(after_creeping(from, time / 2), time / 2);
    return {(4 * halves.y - full.y) / 3, (4 * halves.v - full.v) / 3};
  }
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
  constexpr double kChange = 0.1;  // of the state, in the norm of the energy
  const double size = std::hypot(frequency * from.y, from.v);
  const double rate = std::hypot(frequency * from.v, acceleration(from));
  const double span = kChange * size / rate;
  if (damping_ * span <= kStability) return span;
  // What decays fast changes the sign of v, and bends the path at the begin of a step.
  constexpr double kDecayed = 0.05, kNone = 1e-300;
  const Modes modes = this->modes(from);
  const double smooth =
      kDecayed * std::abs(modes.v_slow) / (damping_ * std::abs(modes.v_fast) + kNone);
  return std::max(kStability / damping_, std::min(span, smooth));
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
