#pragma once

#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// A point of the half-plane.
struct State {
  double y;
  double v;
};

/// A flight from the wall back to it.
struct Winding {
  double height;        ///< largest y
  double duration = 0;  ///< infinite where it creeps to rest
  double landing = 0;   ///< speed into the wall
};

/// The motion between impulses and impacts, y'' + c y' + g(y) = 0: the characteristics of the
/// density equation.
class Flow {
 public:
  explicit Flow(const problem::System& system);

  double damping() const { return damping_; }
  double restitution() const { return restitution_; }
  double acceleration(const State& at) const { return -(damping_ * at.v + force(at.y)); }
  double force(double y) const { return force_(y); }

  /// The state after a time, by one step: the classical Runge-Kutta method's, or, where damping
  /// makes that unstable, an exponential one's with the force's tangent (Rosenbrock and Euler).
  State after(const State& from, double time) const;

  /// The error is of the order 1e-7 of the state in this time, of 1e-6 to 1e-5 in a winding. Where
  /// the flow creeps to rest the steps grow with the time in which it does, and the error is 1e-4.
  /// @param frequency as frequency(state), or of an earlier state with more energy
  double longest_step(const State& from, double frequency) const;
  /// The root of the largest tangent stiffness that the energy of the state gives access to, per
  /// radian.
  double frequency(const State& at) const;
  double energy(const State& at) const;

  /// From the wall with a speed > 0.
  Winding winding(double speed) const;

  /// When, within `time`, a flight from y >= 0 is back at the wall.
  /// @pre it is beyond the wall after `time`
  double impact_time(const State& from, double time) const;

 private:
  /// v = v_slow exp(slow t) + v_fast exp(fast t) with the force's tangent.
  struct Modes {
    double slow, fast, v_slow, v_fast;
  };
  Modes modes(const State& at) const;
  State after_creeping(const State& from, double time) const;

  double damping_;
  double restitution_;
  problem::Polynomial force_, tangent_, potential_;
  problem::System system_;
};

}  // namespace fpkcheck::fd_fpk
