#pragma once

#include <array>
#include <optional>
#include <vector>

#include "problem/system.hpp"

namespace fpkcheck::backward {

/// Displacement and velocity.
struct PhaseState {
  double y, v;
};

/// A point of a quadrature rule in the time since the start of a motion.
struct TimeNode {
  double time, weight;
  PhaseState at;
};

/// Motion from a state until it leaves through the barrier, comes to rest, or until a time limit.
struct Motion {
  std::vector<TimeNode> nodes;
  bool passed_barrier = false;  ///< whether the motion has left through the barrier
  PhaseState end;               ///< last state
  double duration = 0;
};

/// The motion y'' + f(y, y') + g(y) = 0 between impulses, with impacts on the left wall, by Taylor
/// series in panels of time. Panels end at turning points, impacts and the exit through a
/// barrier. Each panel has Gauss points for integrands that are smooth functions of v and of
/// sqrt(barrier - y).
class UnforcedMotion {
 public:
  /// @pre the force is a polynomial, system.has_polynomial_force()
  /// @param barrier displacement right of the left wall
  /// @param velocity_scale change of velocity in which integrands may vary; limits the panels
  /// @param refinement divides the panels
  UnforcedMotion(const problem::System& system, double barrier, double velocity_scale,
                 double refinement);

  /// Returns the motion from a state, for at most the time `until`.
  Motion follow(PhaseState from, double until) const;

  /// Returns the velocities at the displacement y of the motion that ends in the state `end`,
  /// traced back to the barrier, for at most the time `until` and while the speed is below
  /// `fastest`.
  std::vector<double> velocities_before(PhaseState end, double y, double until,
                                        double fastest) const;

  /// Returns the largest speed of the motion that ends in the state `end`, with the limits of
  /// velocities_before().
  double largest_speed_before(PhaseState end, double until, double fastest) const;

  double acceleration(const PhaseState& at) const { return -system_.force(at.y, at.v); }

 private:
  static constexpr int kOrder = 16;  // of the Taylor series
  enum class End { inside, turning_point, impact, exit };
  struct Panel {
    std::array<double, kOrder + 1> y;  // coefficients of the series of y
    double duration;                   // negative backwards in time
    PhaseState end;
    End kind = End::inside;
    bool in_square_root;  // whether integrands are smooth in sqrt(barrier - y)

    PhaseState at(double time) const;
  };
  struct PanelLimit {
    double duration;
    bool in_square_root;
  };

  bool is_at_rest(const PhaseState& at) const;
  std::array<double, kOrder + 1> taylor_coefficients(const PhaseState& from) const;
  PanelLimit panel_limit(const PhaseState& from, int direction) const;
  Panel next_panel(const PhaseState& from, double longest, int direction) const;
  void append_nodes(const PhaseState& from, const Panel& panel, double time,
                    std::vector<TimeNode>& nodes) const;
  template <class Visitor>
  void trace_back(PhaseState end, double until, double fastest, const Visitor& visit) const;

  problem::System system_;
  double barrier_;
  double velocity_scale_, refinement_;
};

}  // namespace fpkcheck::backward
