#pragma once

#include <array>

namespace fpkcheck::problem {
struct Problem;
class System;
class NoiseFactor;
class StateFunction;
class ExcitationTimeDependence;
struct MotionScales;
struct Wall;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

struct SimulatedWall {
  bool exists = false;
  double position = 0;
  double restitution = 1;  ///< r, or r(0) if r depends on the impact speed
  /// Contact force that presses the mass at rest on the wall; if 0 or negative, the mass lifts off
  double contact_force = 0;
  /// Impact speed below which the series of bounces is summed and the mass stays at the wall
  double rest_speed = 0;
  /// Wall with the formula of the restitution coefficient r(u), which must outlive the oscillator;
  /// null for a constant r
  const problem::Wall* formula = nullptr;

  bool has_impact_losses() const { return exists && (restitution < 1 || formula != nullptr); }
};

/// Returns the restitution coefficient r(u) at the impact speed u. @pre wall.formula is not null
double restitution_at_speed(const SimulatedWall& wall, double speed);
/// Returns the total time of the bounces that follow an impact at the speed u <
/// SimulatedWall::rest_speed: the sum of 2 u_n / contact_force with u_n = r(u_(n-1)) u_(n-1), u_0 =
/// u. The total bounce time is infinite if the sum does not converge within 1000 bounces.
/// @pre wall.formula is not null and the contact force is positive
double total_bounce_time(const SimulatedWall& wall, double speed);

/// Oscillator of a problem in wall coordinates, with precomputed coefficients,
///
///     y'' = -(g(y) + y' (c(y) + c_vv y'^2)),    y >= 0 with a left wall, y <= b with a right wall.
///
/// Under Gaussian noise the damping force c y' is part of the kicks (NoiseKicks), not of the
/// flights.
struct SimulatedOscillator {
  static constexpr int kHighestDegree = 5;
  /// Form of the equation of motion, which selects the class of the free flights.
  enum class Kind {
    /// Oscillator with the force g = k y + mu y^3, the damping force c y', c, k, mu >= 0, and one
    /// wall at y = 0, excited by impulses only; free flights are DuffingFlights
    duffing_at_wall,
    // Free flights of the kinds `linear`, `cubic` and `full` are PolynomialFlights. The equation of
    // motion of the kind `cubic` includes the terms of the kind `linear`; the kind `full` includes
    // all terms.
    linear,
    cubic,
    full,
    /// Oscillator whose force is a formula, in `system`; free flights are FormulaFlights
    formula
  };

  /// Coefficients of the restoring force g(y); for the kind `formula`, a constant force that is
  /// added to the formula
  std::array<double, kHighestDegree + 1> force{};
  /// Coefficients of c(y) in the damping force c(y) y'; 0 if the noise kicks contain the damping
  std::array<double, 3> damping{};
  double rayleigh = 0;  ///< coefficient c_vv of the damping c_vv y'^3
  Kind kind = Kind::linear;
  SimulatedWall left{}, right{};

  bool is_duffing_at_wall() const { return kind == Kind::duffing_at_wall; }
  double length = 1;    ///< length scale of the motion, for relative errors of the flights
  double velocity = 1;  ///< velocity scale of the motion
  /// Sum of the frequency and the damping rate of the motion, an upper bound of the rates of change
  double fastest_rate = 1;
  /// Frequency scale of the motion; the frequency that limits the time step of a flight is at least
  /// 1/100 of the frequency scale
  double frequency = 1;

  /// System of the kind `formula`, which must outlive the oscillator; otherwise null
  const problem::System* system = nullptr;
  /// Factor g of multiplicative noise if g depends on v, which must outlive the oscillator;
  /// otherwise null. With G = g^2 and the diffusion coefficient D, the forces f of the senses of
  /// Ito and Stratonovich differ by f_Ito = f_Stratonovich - D G_v / 2.
  const problem::NoiseFactor* noise_factor = nullptr;
  double diffusion = 0;  ///< D, used with `noise_factor`
  bool is_force_in_ito_sense =
      false;               ///< whether the force of `system` as written is that of Ito's sense
  bool has_jumps = false;  ///< Expression::has_jumps()
  bool has_kinks = false;  ///< Expression::has_kinks()
  /// External force F(t), which must outlive the oscillator; null without an external force. An
  /// oscillator with an external force has the kind `formula`.
  const problem::ExcitationTimeDependence* external_force = nullptr;
  /// Factor b(y) of parametric impulses, which must outlive the oscillator; null for b = 1
  const problem::StateFunction* impulse_factor = nullptr;
};

/// Returns the factor b(y) of parametric impulses; 1 for impulses without a factor.
double impulse_factor(const SimulatedOscillator& oscillator, double y);

/// Computes the force of free flights, in Stratonovich's sense, at `count` <= 8 points. At points
/// behind a wall, a force that is not finite is replaced by the force at the wall.
/// @pre oscillator.kind is `formula`
void evaluate_forces(const SimulatedOscillator& oscillator, int count, const double* y,
                     const double* v, double* force);
/// Computes the force of the equation in Ito's sense, which enters the balance equations of the
/// stationary density, at `count` <= 8 points between the walls.
/// @pre oscillator.kind is `formula`
void evaluate_ito_forces(const SimulatedOscillator& oscillator, int count, const double* y,
                         const double* v, double* force);

/// Gaussian white noise, integrated by Strang splitting with the interval h. At a noise kick the
/// velocity y' follows the Ornstein-Uhlenbeck process with damping c for a time h. Between noise
/// kicks neither noise nor the damping force c y' acts on the mass. Noise kicks and free flights
/// preserve the density exp(-c (v^2/2 + U(y))/D). Without impact losses and impulses a finite kick
/// interval h therefore causes no error; otherwise the error is of second order in h. Damping other
/// than c y' acts during the free flights, and under multiplicative noise all damping;
/// apply_multiplicative_kicks() describes the kicks of multiplicative noise.
struct NoiseKicks {
  double diffusion = 0;         ///< diffusion coefficient D of the noise; 0 without kicks
  double damping = 0;           ///< coefficient c of the damping force c y'
  double longest_interval = 0;  ///< largest interval h between kicks
  /// Lower limit of the kick interval next to a wall with impact losses (time_to_next_kick())
  double shortest_interval = 0;
  /// Interval between noise kicks next to a wall with impact losses, as a fraction of the time in
  /// which noise changes the motion
  double fraction_near_wall = 0.1;
  bool has_lossy_wall = false;
  /// Factor g of multiplicative noise, which must outlive the noise kicks; null for g = 1
  const problem::NoiseFactor* factor = nullptr;
  double velocity_scale = 1;  ///< scale of the velocities, used with `factor`

  bool is_acting() const { return diffusion > 0; }
};

/// Returns whether the oscillator of a problem has the kind duffing_at_wall. The kind of the
/// oscillator determines the free flights, the model of white noise (evenly spaced impulses, or
/// NoiseKicks) and the initial states. With one wall at the equilibrium, damping c > 0 and the
/// restoring force g = k y + mu y^3, k, mu >= 0, the energy does not grow between impulses and
/// bounds the frequency. A flight of the kind duffing_at_wall has at most one impact, which the
/// sign of y at the end reveals, and the mass never rests on the wall. The kind duffing_at_wall
/// excludes noise, since noise would increase the energy during a flight.
bool is_duffing_at_wall(const problem::Problem& problem);

/// @param problem must outlive the oscillator if the kind is `formula` or a wall has a formula
/// @param mean_force mean force of the impulses if noise kicks replace the impulses, otherwise 0
/// @param has_noise_kicks whether the motion has NoiseKicks
SimulatedOscillator make_oscillator(const problem::Problem& problem,
                                    const problem::MotionScales& scales, double mean_force = 0,
                                    bool has_noise_kicks = false);

/// Sets SimulatedWall::contact_force to `force`, and SimulatedWall::rest_speed to the impact speed
/// that belongs to this contact force.
void set_contact_force(const SimulatedOscillator& oscillator, double force, SimulatedWall& wall);

/// Computes the external force F(t) at `count` times. @pre oscillator.external_force is not null
void evaluate_external_forces(const SimulatedOscillator& oscillator, int count, const double* t,
                              double* force);

/// Returns the parameters of the noise kicks that represent Gaussian white noise.
/// @param problem must outlive the kicks of multiplicative noise
/// @param diffusion diffusion coefficient D > 0, or 0 without noise
/// @param step interval h between noise kicks, in radians
NoiseKicks make_noise_kicks(const problem::Problem& problem, const problem::MotionScales& scales,
                            double diffusion, double step);

}  // namespace fpkcheck::mcs
