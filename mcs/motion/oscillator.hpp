#pragma once

#include <array>

namespace fpkcheck::problem {
struct Problem;
struct MotionScales;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

/// Parameters of a wall. The contact force presses the mass at rest on the wall.
struct Wall {
  bool exists = false;
  double position = 0;
  double restitution = 1;
  /// Contact force towards the wall; if 0 or negative, the mass lifts off
  double contact_force = 0;
  /// Impact speed below which the series of bounces is summed and the mass stays at the wall.
  double rest_speed = 0;
};

/// The oscillator of a problem in wall coordinates, with precomputed coefficients,
///
///     y'' = -(g(y) + y' (c(y) + c_vv y'^2)),    0 <= y with a wall, y <= b with a second one.
///
/// Under Gaussian noise the damping f = c y' is part of the kicks (NoiseKicks), not of the
/// flights.
struct Oscillator {
  static constexpr int kHighestDegree = 5;
  /// Terms of the equation, which select the flights.
  enum class Kind {
    /// g = k y + mu y^3 and f = c y' with c, k, mu >= 0, one wall at y = 0, impulses alone: the
    /// energy bounds the frequency of a flight (DuffingFlight). See is_duffing_at_wall().
    duffing_at_wall,
    // Terms of a PolynomialFlight; each kind includes the terms of the kinds before.
    linear,
    cubic,
    full
  };

  std::array<double, kHighestDegree + 1> force{};  ///< g
  std::array<double, 3> damping{};                 ///< c; 0 if the damping is part of the kicks
  double rayleigh = 0;                             ///< c_vv
  Kind kind = Kind::linear;
  Wall left{}, right{};

  bool is_duffing_at_wall() const { return kind == Kind::duffing_at_wall; }
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

/// Whether the oscillator of a problem has the kind duffing_at_wall. This property alone decides
/// which flights, which model of white noise (evenly spaced impulses, or NoiseKicks) and which
/// initial states a simulation uses:
/// - With one wall at the equilibrium and c > 0 the energy of g = k y + mu y^3, k, mu >= 0, does
///   not grow between impulses and bounds the frequency. A flight then has at most one impact,
///   which the sign of y at its end reveals, and the mass never rests on the wall.
/// - Noise would let the energy grow during a flight.
bool is_duffing_at_wall(const problem::Problem& problem);

/// Precomputes the coefficients of the oscillator of a problem.
/// @param mean_force mean force of the impulses if kicks replace the impulses, else 0
/// @param kicked whether the motion has NoiseKicks
Oscillator make_oscillator(const problem::Problem& problem, const problem::MotionScales& scales,
                           double mean_force = 0, bool kicked = false);

/// Parameters of the kicks that represent Gaussian noise.
/// @param diffusion D > 0, or 0 without noise
/// @param step interval h between kicks, in radians
NoiseKicks make_noise_kicks(const problem::Problem& problem, const problem::MotionScales& scales,
                            double diffusion, double step);

}  // namespace fpkcheck::mcs
