#pragma once

#include <array>

namespace fpkcheck::problem {
struct Problem;
struct Scales;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

/// Wall parameters for flights. The contact force presses the mass at rest on the wall.
struct GeneralWall {
  bool exists = false;
  double position = 0;
  double restitution = 1;
  double contact_force = 0;  ///< towards the wall; 0 or negative: the mass lifts off
  /// Below this impact speed the series of bounces is summed, and the mass stays at the wall.
  double rest_speed = 0;
};

/// Any oscillator of problem::System in wall coordinates, with precomputed coefficients,
///
///     y'' = -(g(y) + y' (c(y) + c_vv y'^2)),    0 <= y with a wall, y <= b with a second one.
///
/// Under Gaussian noise the damping f = c y' is part of the kicks (GeneralKicks), not of the
/// flights.
struct GeneralOscillator {
  static constexpr int kHighestDegree = 5;
  /// Terms of the equation; each kind includes the terms of the kinds before.
  enum class Kind { linear, cubic, full };

  std::array<double, kHighestDegree + 1> force{};  ///< g
  std::array<double, 3> damping{};                 ///< c; 0 where the kicks include it
  double rayleigh = 0;                             ///< c_vv
  Kind kind = Kind::linear;
  GeneralWall left{}, right{};
  double length = 1;     ///< length scale of the motion, for relative errors of the flights
  double frequency = 1;  ///< frequency scale; a flight uses at least a hundredth of it
};

/// Gaussian white noise by Strang splitting with the interval h. At a kick y' follows the
/// Ornstein-Uhlenbeck process with damping c for a time h. Between kicks the motion has neither
/// noise nor damping c y'. Both steps preserve exp(-c (v^2/2 + U)/D): without impact losses and
/// impulses h causes no error. Otherwise the error is of second order. Damping other than c y' is
/// part of the flights.
struct GeneralKicks {
  double diffusion = 0;          ///< D; 0 without kicks
  double damping = 0;            ///< c, where f = c y'
  double longest_interval = 0;   ///< h
  double shortest_interval = 0;  ///< lower limit of h next to a wall with losses; see kick_interval
  bool has_lossy_wall = false;   ///< a wall has impact losses

  bool is_present() const { return diffusion > 0; }
};

/// @param mean_force mean of the impulses where noise replaces them, else 0
/// @param kicked whether there is Gaussian noise
GeneralOscillator general_oscillator(const problem::Problem& problem, const problem::Scales& scales,
                                     double mean_force, bool kicked);

/// @param diffusion D > 0, or 0 without noise
/// @param step h in radians
GeneralKicks general_kicks(const problem::Problem& problem, const problem::Scales& scales,
                           double diffusion, double step);

}  // namespace fpkcheck::mcs
