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

/// An end of the displacement axis, where a wall may be.
enum class Side { left, right };
/// The sign of a velocity away from the wall on that side.
constexpr double inward_sign(Side side) { return side == Side::left ? 1 : -1; }

/// The displacements energetically accessible without losses: between the turning points or walls.
struct AccessibleInterval {
  double low, high;
  double least_potential;  ///< least potential in the interval
  double frequency;        ///< square root of the largest |g'(y)| in the interval, per radian
};

/// The motion from the left wall to the next impact on the same wall.
struct HalfCycle {
  double height;            ///< largest distance from the wall
  double duration = 0;      ///< infinite when the motion does not return
  double impact_speed = 0;  ///< speed of the impact
};

/// The motion between impulses and impacts, y'' + f(y, y') + g(y) = 0: the characteristics of the
/// density equation.
class Flow {
 public:
  /// @pre the damping dissipates energy everywhere: f v >= 0
  explicit Flow(const problem::System& system);

  const std::optional<problem::Wall>& wall(Side side) const {
    return side == Side::left ? system_.left() : system_.right();
  }
  /// Distance to the wall; negative behind it. @pre the wall exists
  double distance(double y, Side side) const;
  /// The wall behind which the displacement lies, if any.
  std::optional<Side> beyond(double y) const;

  double acceleration(const State& at) const;
  /// The rate at which areas in the phase plane shrink, df/dv (Liouville).
  double contraction(const State& at) const;
  double force(double y) const { return force_(y); }
  double energy(const State& at) const { return at.v * at.v / 2 + potential_(at.y); }
  double potential(double y) const { return potential_(y); }
  /// Extrema of the potential U between the walls, increasing.
  const std::vector<double>& potential_extrema() const { return potential_extrema_; }

  /// The state at the end of one time step: by the classical Runge-Kutta method, or, where damping
  /// makes that method unstable, by an exponential (Rosenbrock-Euler) method with the tangents of f
  /// and g.
  State advance(const State& from, double time) const;

  /// The largest accurate time step. The relative error of the state is of the order 1e-7 in one
  /// step and 1e-6 to 1e-5 in a half-cycle. Where overdamped motion approaches rest, the steps grow
  /// with its time scale, and the error is 1e-4.
  /// @param accessible_interval of this state, or of an earlier state with more energy
  double max_step(const State& from, const AccessibleInterval& accessible_interval) const;
  AccessibleInterval accessible_interval(const State& at) const;

  /// The half-cycle from the left wall with an initial speed > 0.
  HalfCycle half_cycle(double speed) const;

  /// The time at which a flight meets the wall.
  /// @pre the state is behind the wall at the end of `time`
  double impact_time(const State& from, double time, Side side) const;

 private:
  /// v = v_slow exp(slow t) + v_fast exp(fast t), with the tangents of the forces.
  struct Modes {
    double slow, fast, v_slow, v_fast;
  };
  Modes modes(const State& at) const;
  State advance_overdamped(const State& from, double time) const;
  double end_of_accessible_interval(double y, double energy, Side side) const;

  problem::System system_;
  numerics::Polynomial force_, tangent_, potential_, damping_, damping_slope_;
  double rayleigh_;
  std::vector<double> potential_extrema_, stiffness_extrema_;  // extrema of U; extrema of g'
};

}  // namespace fpkcheck::fd_fpk
