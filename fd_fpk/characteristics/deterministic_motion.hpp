#pragma once

#include <optional>
#include <vector>

#include "problem/effective_potential.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

struct PhaseState {
  double y;
  double v;
};

enum class WallSide { left, right };
/// Returns the sign of the velocity of motion away from the wall on the given side.
constexpr double inward_sign(WallSide side) { return side == WallSide::left ? 1 : -1; }

/// Interval of displacements that undamped motion from a given state would reach. Each end of the
/// interval of accessible displacements is a turning point or a wall.
struct AccessibleDisplacements {
  double low, high;
  double least_potential;
  /// Square root of the largest |g'(y)| of the restoring force g in the interval, in radians per
  /// unit time
  double frequency;
};

/// Half-cycle of the oscillator: the motion from the left wall to the next impact on the left wall.
struct HalfCycle {
  double height;        ///< largest distance from the wall during the half-cycle
  double duration = 0;  ///< duration of the half-cycle; infinite without a further impact
  double impact_speed = 0;
};

/// Deterministic motion between impulses and impacts, y'' + f(y, y') + g(y) = 0 with the damping
/// force f and the restoring force g. The trajectories of the deterministic motion are the
/// characteristics of the density equation.
class DeterministicFlow {
 public:
  explicit DeterministicFlow(const problem::System& system);

  const std::optional<problem::Wall>& wall(WallSide side) const {
    return side == WallSide::left ? system_.left_wall() : system_.right_wall();
  }
  /// Returns the distance of y from the wall on the given side; negative if y is behind the wall.
  /// @pre the wall exists
  double distance_from_wall(double y, WallSide side) const;
  /// Returns the side of the wall behind which y is; empty if y is between the walls.
  std::optional<WallSide> wall_passed_by_displacement(double y) const;

  double acceleration(const PhaseState& state) const;
  /// Returns the relative rate df/dv at which the flow contracts areas of the phase plane
  /// (Liouville), with the damping force f and the velocity v.
  double contraction_rate(const PhaseState& state) const;
  double static_force(double y) const { return system_.force(y, 0); }
  double mechanical_energy(const PhaseState& state) const {
    return state.v * state.v / 2 + potential_(state.y);
  }
  double potential_energy(double y) const { return potential_(y); }
  /// Returns the positions of the extrema of the potential between the walls, in increasing order.
  const std::vector<double>& potential_extrema() const { return potential_.extremum_positions(); }

  /// Returns the state after one time step of the classical Runge-Kutta method. Where strong
  /// damping makes the Runge-Kutta method unstable, an exponential (Rosenbrock-Euler) method with
  /// linearised damping and restoring forces computes the state.
  PhaseState advance_state(const PhaseState& from, double duration) const;

  /// Returns the largest time step with which advance_state() is accurate. With the largest
  /// accurate time step, the relative error of the state is about 1e-7 after one step and 1e-6 to
  /// 1e-5 after a half-cycle of the oscillator. For overdamped motion towards a rest point the
  /// relative error of the state is 1e-4.
  /// @param accessible_displacements interval of displacements accessible from the state `from` or
  /// from an earlier state of the motion
  double max_time_step(const PhaseState& from,
                       const AccessibleDisplacements& accessible_displacements) const;
  AccessibleDisplacements accessible_displacements(const PhaseState& state) const;

  /// Returns the half-cycle that starts at the left wall with the given speed > 0.
  HalfCycle half_cycle(double speed) const;

  /// Returns the time after which flight from the state `from` reaches the wall on the given side.
  /// @pre the displacement is behind the wall after the time `duration`
  double impact_time(const PhaseState& from, double duration, WallSide side) const;

 private:
  /// Slow and fast mode of overdamped motion under linearised forces, with the velocity v(t) =
  /// v_slow exp(slow t) + v_fast exp(fast t).
  struct OverdampedModes {
    double slow, fast, v_slow, v_fast;
  };
  bool is_overdamped(const PhaseState& state) const;
  OverdampedModes overdamped_modes(const PhaseState& state) const;
  PhaseState advance_overdamped(const PhaseState& from, double duration) const;
  double resolved_time_step(const PhaseState& from, double duration, double size,
                            double frequency) const;
  double end_of_accessible_interval(double y, double energy, WallSide side) const;
  double largest_stiffness(double low, double high) const;

  problem::System system_;
  problem::EffectivePotential potential_;  // of the spring alone
  std::vector<double> stiffness_extrema_;  // extrema of the tangent stiffness g', a polynomial
};

}  // namespace fpkcheck::fd_fpk
