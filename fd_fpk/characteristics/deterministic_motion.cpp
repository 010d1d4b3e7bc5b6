#include "fd_fpk/characteristics/deterministic_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "numerics/roots/bracketed_root.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Largest product of the damping coefficient and the Runge-Kutta time step. The stability limit of
// the Runge-Kutta method on the negative real axis is 2.78; for products up to 0.75 the computed
// decay is accurate.
constexpr double kStability = 0.75;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns int_0^t exp(s t') dt' = expm1(s t) / s.
double integrated_exponential(double s, double duration) {
  return s == 0 ? duration : std::expm1(s * duration) / s;
}

}  // namespace

DeterministicFlow::DeterministicFlow(const problem::System& system)
    : system_(system), potential_(system) {
  if (system.has_polynomial_force()) {
    stiffness_extrema_ = problem::polynomial_sign_changes_between_walls(
        system.tangent_stiffness().derivative(), system);
  }
}

double DeterministicFlow::distance_from_wall(double y, WallSide side) const {
  assert(wall(side));
  return inward_sign(side) * (y - wall(side)->position);
}

std::optional<WallSide> DeterministicFlow::wall_passed_by_displacement(double y) const {
  if (system_.left_wall() && y < system_.left_wall()->position) return WallSide::left;
  if (system_.right_wall() && y > system_.right_wall()->position) return WallSide::right;
  return std::nullopt;
}

double DeterministicFlow::acceleration(const PhaseState& state) const {
  return -system_.force(state.y, state.v);
}

double DeterministicFlow::contraction_rate(const PhaseState& state) const {
  return system_.force_slope_in_v(state.y, state.v);
}

// Returns the exact solution after a time step for forces linearised about the state. The exact
// solution consists of exponentials exp(s t) with the roots s of s^2 + f_v s + (f_y + g') = 0,
// where f is the damping force and g the restoring force. The roots s are real whenever a time step
// exceeds the stability limit of explicit methods.
PhaseState DeterministicFlow::advance_overdamped(const PhaseState& from, double duration) const {
  const auto [slow, fast, v_slow, v_fast] = overdamped_modes(from);
  return {from.y + v_slow * integrated_exponential(slow, duration) +
              v_fast * integrated_exponential(fast, duration),
          v_slow * std::exp(slow * duration) + v_fast * std::exp(fast * duration)};
}

bool DeterministicFlow::is_overdamped(const PhaseState& state) const {
  const double damping = contraction_rate(state);
  return damping > 0 && damping * damping > 4 * system_.force_slope_in_y(state.y, state.v);
}

DeterministicFlow::OverdampedModes DeterministicFlow::overdamped_modes(
    const PhaseState& state) const {
  const double damping = contraction_rate(state);
  const double stiffness = system_.force_slope_in_y(state.y, state.v);
  const double root = std::sqrt(std::max(0.0, damping * damping - 4 * stiffness));
  const double fast = -(damping + root) / 2, slow = -2 * stiffness / (damping + root);
  const double v_fast = (acceleration(state) - slow * state.v) / (fast - slow);
  return {.slow = slow, .fast = fast, .v_slow = state.v - v_fast, .v_fast = v_fast};
}

PhaseState DeterministicFlow::advance_state(const PhaseState& from, double duration) const {
  if (contraction_rate(from) * duration > kStability && is_overdamped(from)) {
    const PhaseState full = advance_overdamped(from, duration);
    const PhaseState halves =
        advance_overdamped(advance_overdamped(from, duration / 2), duration / 2);
    return {(4 * halves.y - full.y) / 3, (4 * halves.v - full.v) / 3};
  }
  const double half = duration / 2;
  const PhaseState a{from.v, acceleration(from)};
  const PhaseState at_b{from.y + half * a.y, from.v + half * a.v};
  const PhaseState b{at_b.v, acceleration(at_b)};
  const PhaseState at_c{from.y + half * b.y, from.v + half * b.v};
  const PhaseState c{at_c.v, acceleration(at_c)};
  const PhaseState at_d{from.y + duration * c.y, from.v + duration * c.v};
  const PhaseState d{at_d.v, acceleration(at_d)};
  return {from.y + duration / 6 * (a.y + 2 * b.y + 2 * c.y + d.y),
          from.v + duration / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
}

double DeterministicFlow::max_time_step(
    const PhaseState& from, const AccessibleDisplacements& accessible_displacements) const {
  // Largest relative change of the oscillator state in one time step, in the energy norm
  constexpr double kChange = 0.1;
  // Near a saddle, and where the force is zero, the rate of change of the state is small but may
  // increase quickly, so that kLongest and kIntervalFraction also limit the time step.
  constexpr double kLongest = 0.3, kIntervalFraction = 0.1;
  const double size = std::sqrt(
      2 * std::max(0.0, mechanical_energy(from) - accessible_displacements.least_potential));
  const double rate = std::hypot(accessible_displacements.frequency * from.v, acceleration(from));
  const double free = kChange * size / rate;
  const double across = accessible_displacements.high > accessible_displacements.low
                            ? kIntervalFraction *
                                  (accessible_displacements.high - accessible_displacements.low) /
                                  std::abs(from.v)
                            : kInfinity;
  const double span = std::min({free, kLongest / accessible_displacements.frequency, across});
  if (!system_.has_polynomial_force()) {
    return resolved_time_step(from, span, size, accessible_displacements.frequency);
  }
  const double damping = contraction_rate(from);
  if (damping * span <= kStability) return span;
  if (!is_overdamped(from)) return kStability / damping;
  // At first, the fast mode of overdamped motion may reverse the velocity and curve the trajectory.
  constexpr double kDecayed = 0.05, kNone = 1e-300;
  const OverdampedModes modes = this->overdamped_modes(from);
  const double smooth =
      kDecayed * std::abs(modes.v_slow) / (damping * std::abs(modes.v_fast) + kNone);
  return std::max(kStability / damping, std::min({free, smooth, across}));
}

// Returns the longest time step, `duration` divided by a power of 2, whose result agrees with the
// result of two half steps. The force and its slopes at one state do not determine an accurate time
// step, because a force such as tanh(20 v) may change sharply within the step.
double DeterministicFlow::resolved_time_step(const PhaseState& from, double duration, double size,
                                             double frequency) const {
  // Largest accepted error of a time step relative to the state, in the energy norm. With the value
  // 1e-8 instead of 1e-6 of the error limit, E[y^2] for the force 0.02*v + 0.1*tanh(20*v) + y at a
  // wall changes by a relative 5e-6 (`fpkcheck fd --transport characteristics`).
  constexpr double kError = 1e-6;
  constexpr int kMostHalvings = 20;
  PhaseState full = advance_state(from, duration);
  for (int n = 0; n < kMostHalvings; ++n) {
    const PhaseState half = advance_state(from, duration / 2);
    const PhaseState end = advance_state(half, duration / 2);
    if (std::hypot(frequency * (end.y - full.y), end.v - full.v) <= kError * size) break;
    duration /= 2;
    full = half;
  }
  return duration;
}

// Returns the largest |g'(y)| of the restoring force g between two displacements.
double DeterministicFlow::largest_stiffness(double low, double high) const {
  double largest = 0;
  const auto inspect = [&](double y) {
    if (y >= low && y <= high)
      largest = std::max(largest, std::abs(system_.force_slope_in_y(y, 0)));
  };
  inspect(low);
  inspect(high);
  for (const double y : stiffness_extrema_) inspect(y);
  if (!system_.has_polynomial_force()) {
    // If the stiffness has a larger maximum between the sampled displacements, resolved_time_step()
    // shortens the time step.
    constexpr int kIntervals = 16;
    for (int n = 1; n < kIntervals; ++n) inspect(low + (high - low) * n / kIntervals);
  }
  return largest;
}

// The potential is monotone between its extrema, and increases beyond its outermost extrema.
double DeterministicFlow::end_of_accessible_interval(double y, double energy, WallSide side) const {
  const double sign = -inward_sign(side);
  const auto inside = [&](double at) { return potential_(at) < energy; };
  const auto between = [&](double within, double beyond) {
    constexpr int kBits = 30;
    return numerics::bracketed_root([&](double at) { return potential_(at) - energy; },
                                    std::min(within, beyond), std::max(within, beyond), kBits);
  };
  double reached = y;
  const auto passes = [&](double knot) {
    if (sign * (knot - reached) <= 0) return true;
    if (!inside(knot)) return false;
    reached = knot;
    return true;
  };
  const auto count = static_cast<int>(potential_extrema().size());
  for (int n = 0; n < count; ++n) {
    const double turn = potential_extrema()[side == WallSide::left ? count - 1 - n : n];
    if (!passes(turn)) return between(reached, turn);
  }
  if (const auto& end = wall(side)) {
    return passes(end->position) ? end->position : between(reached, end->position);
  }
  double step = std::max(1e-3 * std::abs(reached), 1e-30);
  while (inside(reached + sign * step)) step *= 2;
  return between(reached, reached + sign * step);
}

AccessibleDisplacements DeterministicFlow::accessible_displacements(const PhaseState& state) const {
  const double level = mechanical_energy(state);
  AccessibleDisplacements accessible_displacements{
      .low = end_of_accessible_interval(state.y, level, WallSide::left),
      .high = end_of_accessible_interval(state.y, level, WallSide::right),
      .least_potential = 0,
      .frequency = 0};
  const auto inside = [&](double y) {
    return y > accessible_displacements.low && y < accessible_displacements.high;
  };
  accessible_displacements.least_potential =
      std::min(potential_(accessible_displacements.low), potential_(accessible_displacements.high));
  for (const double y : potential_extrema()) {
    if (inside(y))
      accessible_displacements.least_potential =
          std::min(accessible_displacements.least_potential, potential_(y));
  }
  accessible_displacements.frequency =
      std::sqrt(largest_stiffness(accessible_displacements.low, accessible_displacements.high));
  return accessible_displacements;
}

HalfCycle DeterministicFlow::half_cycle(double speed) const {
  constexpr double kCreeping = 1e-6;
  const double wall = system_.left_wall()->position;
  PhaseState state{wall, speed};
  HalfCycle half_cycle{.height = 0, .duration = kInfinity};
  double duration = 0;
  const AccessibleDisplacements accessible_displacements = this->accessible_displacements(state);
  while (mechanical_energy(state) - accessible_displacements.least_potential >
         kCreeping * speed * speed) {
    const double span = max_time_step(state, accessible_displacements);
    const PhaseState end = advance_state(state, span);
    if (state.v > 0 && end.v <= 0) {
      // Linear interpolation of the velocity gives the time of the turning point.
      const double until = span * state.v / (state.v - end.v);
      half_cycle.height = std::max(half_cycle.height, advance_state(state, until).y - wall);
    }
    const auto hit = wall_passed_by_displacement(end.y);
    if (hit == WallSide::left) {
      const double until = impact_time(state, span, WallSide::left);
      half_cycle.impact_speed = -advance_state(state, until).v;
      half_cycle.duration = duration + until;
      break;
    }
    if (hit) {
      half_cycle.height = system_.right_wall()->position - wall;
      break;
    }
    duration += span;
    state = end;
  }
  return half_cycle;
}

double DeterministicFlow::impact_time(const PhaseState& from, double duration,
                                      WallSide side) const {
  assert(distance_from_wall(advance_state(from, duration).y, side) <= 0);
  double before = 0, until = duration;
  const double distance_now = distance_from_wall(from.y, side);
  // The initial guess of the impact time is the time at which the straight chord of the trajectory
  // reaches the wall. For a flight that starts at the wall, the initial guess of the impact time is
  // half of the time step.
  double guess =
      distance_now > 0
          ? duration * distance_now /
                (distance_now - distance_from_wall(advance_state(from, duration).y, side))
          : duration / 2;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const PhaseState at = advance_state(from, guess);
    const double left = distance_from_wall(at.y, side);
    (left < 0 ? until : before) = guess;
    double next = guess - left / (inward_sign(side) * at.v);
    if (!(next > before && next < until)) next = (before + until) / 2;
    const bool close = std::abs(next - guess) <= 1e-13 * duration;
    guess = next;
    if (close) break;
  }
  return guess;
}

}  // namespace fpkcheck::fd_fpk
