#pragma once

#include <array>

namespace fpkcheck::problem {
struct Problem;
struct Scales;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

/// A wall as flights take it. What presses on it is the force at rest there.
struct GeneralWall {
  bool stands = false;
  double position = 0;
  double restitution = 1;
  double pressing = 0;  ///< what the force presses by; 0 or less: it lifts the mass off
  /// An impact slower than this is followed by bounces that are summed up: the mass stays where it is.
  double slow = 0;
};

/// Any oscillator of problem::System in its frame, as flights take it,
///
///     y'' = -(g(y) + y' (c(y) + c_vv y'^2)),    0 <= y with a wall, y <= b with a second one.
///
/// Under Gaussian noise f = c y' belongs to the kicks (GeneralKicks) and is no part of the flights.
struct GeneralOscillator {
  static constexpr int kHighestDegree = 5;
  /// Which terms there are: each has those before.
  enum class Kind { linear, cubic, full };

  std::array<double, kHighestDegree + 1> force{};  ///< g
  std::array<double, 3> damping{};                 ///< c; 0 where it belongs to the kicks
  double rayleigh = 0;                             ///< c_vv
  Kind kind = Kind::linear;
  GeneralWall left{}, right{};
  double length = 1;     ///< of the motion, which errors of the flights are relative to
  double frequency = 1;  ///< no flight is longer than for a hundredth of it
};

/// Gaussian white noise by Strang's splitting: at times h apart, y' goes on as an
/// Ornstein-Uhlenbeck process with the damping c for a time h; between, the motion goes on without
/// noise and without c y'. Where walls take nothing and there are no impulses, both keep
/// exp(-c (v^2/2 + U)/D): there is no error in h. Elsewhere it is of the second order. Any other
/// damping than c y' stays with the flights.
struct GeneralKicks {
  double diffusion = 0;  ///< D; 0: there are none
  double damping = 0;    ///< c, where f = c y'
  double longest = 0;    ///< h
  double shortest = 0;   ///< of h next to a wall that takes energy; see kick_interval
  bool graded = false;   ///< there is such a wall

  bool present() const { return diffusion > 0; }
};

/// @param mean_force of what stands for the impulses where they are simulated as noise
GeneralOscillator general_oscillator(const problem::Problem& problem, const problem::Scales& scales,
                                     double mean_force, bool kicked);

/// @param diffusion D > 0, or 0 for none
/// @param step radians between kicks
GeneralKicks general_kicks(const problem::Problem& problem, const problem::Scales& scales,
                           double diffusion, double step);

}  // namespace fpkcheck::mcs
