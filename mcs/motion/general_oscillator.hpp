#pragma once

#include <array>

namespace fpkcheck::problem {
struct Problem;
struct MotionScales;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

/// Parameters of a wall. The contact force presses the mass at rest on the wall.
struct GeneralWall {
  bool exists = false;
  double position = 0;
  double restitution = 1;
  /// Contact force towards the wall; if 0 or negative, the mass lifts off
  double contact_force = 0;
  /// Impact speed below which the series of bounces is summed and the mass stays at the wall.
  double rest_speed = 0;
};

/// Any oscillator of problem::System in wall coordinates, with precomputed coefficients,
///
///     y'' = -(g(y) + y' (c(y) + c_vv y'^2)),    0 <= y with a wall, y <= b with a second one.
///
/// Under Gaussian noise the damping f = c y' is part of the kicks (NoiseKicks), not of the
/// flights.
struct GeneralOscillator {
  static constexpr int kHighestDegree = 5;
  /// Terms of the equation; each kind includes the terms of the kinds before.
  enum class Kind { linear, cubic, full };

  std::array<double, kHighestDegree + 1> force{};  ///< g
  std::array<double, 3> damping{};                 ///< c; 0 if the damping is part of the kicks
  double rayleigh = 0;                             ///< c_vv
  Kind kind = Kind::linear;
  GeneralWall left{}, right{};
  double length = 1;  ///< length scale of the motion, for relative errors of the flights
  /// Frequency scale of the motion. The frequency that limits a flight is at least a hundredth of
  /// this scale.
  double frequency = 1;
};

/// Gaussian white noise, integrated by Strang splitting with the interval h. At a kick y' follows
/// the Ornstein-Uhlenbeck process with damping c for a time h. Between kicks the motion has neither
/// noise nor damping c y'. Kicks and flights both preserve the density exp(-c (v^2/2 + U)/D).
/// Without impact losses and impulses a finite h therefore causes no error; otherwise the error is
/// of second order in h. Damping other than c y' is part of the flights.
struct NoiseKicks {
  double diffusion = 0;         ///< D; 0 without kicks
  double damping = 0;           ///< c, where f = c y'
  double longest_interval = 0;  ///< h
  /// Lower limit of h next to a wall with losses; see time_to_next_kick()
  double shortest_interval = 0;
  bool has_lossy_wall = false;  ///< whether a wall has impact losses

  bool is_present() const { return diffusion > 0; }
};

/// Precomputes the coefficients of the oscillator of a problem.
/// @param mean_force mean force of the impulses if noise replaces the impulses, else 0
/// @param kicked whether Gaussian noise is present
GeneralOscillator make_general_oscillator(const problem::Problem& problem,
                                          const problem::MotionScales& scales, double mean_force,
                                          bool kicked);

/// Parameters of the kicks that represent Gaussian noise.
/// @param diffusion D > 0, or 0 without noise
/// @param step interval h between kicks, in radians
NoiseKicks noise_kicks(const problem::Problem& problem, const problem::MotionScales& scales,
                       double diffusion, double step);

}  // namespace fpkcheck::mcs
