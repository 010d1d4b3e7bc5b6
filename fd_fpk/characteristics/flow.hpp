#pragma once

#include <optional>
#include <vector>

#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// A point of the phase plane of displacement and velocity.
struct State {
  double y;
  double v;
};

/// The left or the right end of the displacement axis, at which there may be a wall.
enum class WallSide { left, right };
/// The sign of the velocity with which a motion leaves the wall on the given side.
constexpr double inward_sign(WallSide side) { return side == WallSide::left ? 1 : -1; }

/// The interval of displacements that undamped motion from a state would reach. Each end of the
/// accessible interval is a turning point or a wall.
struct AccessibleInterval {
  double low, high;
  double least_potential;  ///< smallest potential in the interval
  /// square root of the largest |g'(y)| in the interval, in radians per unit time
  double frequency;
};

/// A half-cycle: the motion from the left wall to the next impact on the left wall.
struct HalfCycle {
  double height;            ///< largest distance from the wall during the half-cycle
  double duration = 0;      ///< infinite if there is no further impact
  double impact_speed = 0;  ///< impact speed at the end
};

/// The motion between impulses and impacts, y'' + f(y, y') + g(y) = 0: the characteristics of the
/// density equation.
class Flow {
 public:
  /// @pre the damping dissipates energy everywhere: f v >= 0
  explicit Flow(const problem::System& system);

  const std::optional<problem::Wall>& wall(WallSide side) const {
    return side == WallSide::left ? system_.left_wall() : system_.right_wall();
  }
  /// Distance of the displacement y from the wall on the given side; negative behind the wall. @pre
  /// the wall exists
  double distance(double y, WallSide side) const;
  /// The wall behind which the displacement y is; empty if y is between the walls.
  std::optional<WallSide> wall_passed_at(double y) const;

  double acceleration(const State& at) const;
  /// The relative rate df/dv at which the flow contracts areas of the phase plane (Liouville), with
  /// the damping force f.
  double contraction_rate(const State& at) const;
  double force(double y) const { return force_(y); }
  double energy(const State& at) const { return at.v * at.v / 2 + potential_(at.y); }
  double potential(double y) const { return potential_(y); }
  /// Positions of the extrema of the potential U between the walls, in increasing order.
  const std::vector<double>& potential_extrema() const { return potential_extrema_; }

  /// The state at the end of one time step: by the classical Runge-Kutta method, or, where strong
  /// damping makes the Runge-Kutta method unstable, by an exponential (Rosenbrock-Euler) method
  /// with the tangents of f and g.
  State advance(const State& from, double time) const;

  /// The largest time step with which advance() is accurate. The relative error of the state is of
  /// the magnitude 1e-7 after one step and 1e-6 to 1e-5 after a half-cycle. When overdamped motion
  /// approaches a rest point, the steps increase with the time scale of the motion, and the
  /// relative error is 1e-4.
  /// @param accessible_interval accessible interval of the state `from`, or of an earlier state of
  /// the motion with more energy
  double max_step(const State& from, const AccessibleInterval& accessible_interval) const;
  AccessibleInterval accessible_interval(const State& at) const;

  /// Computes the half-cycle that starts at the left wall with the given speed > 0.
  HalfCycle half_cycle(double speed) const;

  /// The time after which a flight from the state `from` meets the wall.
  /// @pre the state is behind the wall at the end of `time`
  double impact_time(const State& from, double time, WallSide side) const;

 private:
  /// The two modes of overdamped motion, v = v_slow exp(slow t) + v_fast exp(fast t), which solve
  /// the equation of motion linearised by the tangents of the forces.
  struct OverdampedModes {
    double slow, fast, v_slow, v_fast;
  };
  OverdampedModes overdamped_modes(const State& at) const;
  State advance_overdamped(const State& from, double time) const;
  double end_of_accessible_interval(double y, double energy, WallSide side) const;

  problem::System system_;
  numerics::Polynomial force_, tangent_, potential_, damping_, damping_slope_;
  double rayleigh_;
  // positions of the extrema of the potential U, and of the tangent stiffness g'
  std::vector<double> potential_extrema_, stiffness_extrema_;
};

}  // namespace fpkcheck::fd_fpk
