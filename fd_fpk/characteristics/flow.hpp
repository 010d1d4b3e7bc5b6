#pragma once

#include <optional>
#include <vector>

#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// A point of the plane of displacement and velocity.
struct State {
  double y;
  double v;
};

/// An end of the motion at which a wall may stand.
enum class Side { left, right };
/// The sign of a velocity off the wall on that side.
constexpr double inwards(Side side) { return side == Side::left ? 1 : -1; }

/// What a motion of an energy may reach, were nothing lost: from turning point, or wall, to turning
/// point.
struct Reach {
  double low, high;
  double least_potential;  ///< within
  double frequency;        ///< the root of the largest |g'(y)| within, per radian
};

/// A flight from the wall on the left back to it.
struct Winding {
  double height;        ///< largest distance from the wall
  double duration = 0;  ///< infinite where it does not come back
  double landing = 0;   ///< speed into the wall
};

/// The motion between impulses and impacts, y'' + f(y, y') + g(y) = 0: the characteristics of the
/// density equation.
class Flow {
 public:
  /// @pre the damping takes energy everywhere: f v >= 0
  explicit Flow(const problem::System& system);

  const std::optional<problem::Wall>& wall(Side side) const {
    return side == Side::left ? system_.left() : system_.right();
  }
  /// How far it is to the wall; negative beyond it. @pre there is one
  double distance(double y, Side side) const;
  /// The state is beyond a wall: which.
  std::optional<Side> beyond(double y) const;

  double acceleration(const State& at) const;
  /// The rate at which areas shrink, df/dv (Liouville).
  double contraction(const State& at) const;
  double force(double y) const { return force_(y); }
  double energy(const State& at) const { return at.v * at.v / 2 + potential_(at.y); }
  double potential(double y) const { return potential_(y); }
  /// Where U turns between the walls, increasing.
  const std::vector<double>& turns() const { return turns_; }

  /// The state after a time, by one step: the classical Runge-Kutta method's, or, where damping
  /// makes that unstable, an exponential one's with the tangents of f and g (Rosenbrock and Euler).
  State after(const State& from, double time) const;

  /// The error is of the order 1e-7 of the state in this time, of 1e-6 to 1e-5 in a winding. Where
  /// the flow creeps to rest the steps grow with the time in which it does, and the error is 1e-4.
  /// @param reach as reach(state), or of an earlier state with more energy
  double longest_step(const State& from, const Reach& reach) const;
  Reach reach(const State& at) const;

  /// From the wall on the left with a speed > 0.
  Winding winding(double speed) const;

  /// When, within `time`, a flight is at the wall.
  /// @pre it is beyond the wall after `time`
  double impact_time(const State& from, double time, Side side) const;

 private:
  /// v = v_slow exp(slow t) + v_fast exp(fast t) with the tangents of the forces.
  struct Modes {
    double slow, fast, v_slow, v_fast;
  };
  Modes modes(const State& at) const;
  State after_creeping(const State& from, double time) const;
  double end_of_reach(double y, double energy, Side side) const;

  problem::System system_;
  numerics::Polynomial force_, tangent_, potential_, damping_, damping_slope_;
  double rayleigh_;
  std::vector<double> turns_, bends_;  // of U; of g'
};

}  // namespace fpkcheck::fd_fpk
