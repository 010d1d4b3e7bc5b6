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

/// Node of a quadrature rule in time along a trajectory.
struct TrajectoryQuadratureNode {
  double time;    ///< time since the start of the trajectory
  double weight;  ///< quadrature weight, in units of time
  PhaseState state;
};

/// Whether the process ends at the barrier, or continues beyond the barrier.
enum class BarrierKind { absorbing, permeable };

/// Whether a trajectory contains the nodes of a quadrature rule in time, or its end alone.
enum class TrajectoryNodeSelection { quadrature_nodes, end_only };

/// Trajectory from an initial state until the passage of the barrier, rest or a time limit. The
/// integral of g(X_t) over the duration is the sum of weight g(state) over all nodes.
struct UnforcedTrajectory {
  std::vector<TrajectoryQuadratureNode> nodes;
  bool passed_barrier = false;  ///< whether the trajectory ends by the passage of the barrier
  PhaseState end_state;
  double duration = 0;
};

/// Solver of the motion between impulses, y'' + f(y, y') + g(y) = 0 with impacts on the left wall.
/// The solver divides the time into panels and expands y in a Taylor series in each panel. Panels
/// end at turning points, at impacts and at the passage of the barrier. Each panel has Gauss points
/// for integrands that are smooth functions of v and of sqrt(barrier - y).
class UnforcedMotionSolver {
 public:
  /// @pre the force is a polynomial, system.has_polynomial_force()
  /// @param barrier displacement of the barrier, above the left wall; infinity without a barrier
  /// @param displacement_scale scale of the displacements; in one panel the displacement changes by
  /// about half of this scale at most
  /// @param velocity_scale scale on which integrands vary with the velocity; in one panel the
  /// velocity changes by about this scale at most
  /// @param panel_refinement factor by which the panels are shorter than with the factor 1
  /// @param barrier_kind whether trajectories that are traced backward in time end at the barrier
  UnforcedMotionSolver(const problem::System& system, double barrier, double displacement_scale,
                       double velocity_scale, double panel_refinement,
                       BarrierKind barrier_kind = BarrierKind::absorbing);

  /// Computes the trajectory from a state below or above the barrier, until the trajectory reaches
  /// the barrier, for at most the duration `max_duration`. From a state at the barrier the
  /// trajectory continues until its next passage.
  /// @pre the quadrature nodes are computed below the barrier only
  UnforcedTrajectory compute_trajectory(
      PhaseState start, double max_duration,
      TrajectoryNodeSelection content = TrajectoryNodeSelection::quadrature_nodes) const;

  /// Traces the trajectory that ends in the state `end` backward in time. Returns the velocities at
  /// which this trajectory crosses the displacement y. The trace stops at an absorbing barrier,
  /// after the time `max_duration`, and where the speed reaches `max_speed`.
  std::vector<double> find_backward_crossing_velocities(PhaseState end, double y,
                                                        double max_duration,
                                                        double max_speed) const;

  /// Traces the trajectory that ends in the state `end` backward in time, with the limits of
  /// find_backward_crossing_velocities(). Returns the largest speed on this trajectory.
  double find_largest_backward_speed(PhaseState end, double max_duration, double max_speed) const;

  /// Traces the trajectory that ends in the state `end` backward in time, with the limits of
  /// find_backward_crossing_velocities(). Returns the displacements of its turning points.
  std::vector<double> find_backward_turning_points(PhaseState end, double max_duration,
                                                   double max_speed) const;

  double acceleration(const PhaseState& state) const { return -system_.force(state.y, state.v); }

 private:
  static constexpr int kTaylorOrder = 16;  // highest power of the Taylor series of y
  enum class PanelEnd { interior, turning_point, impact, barrier_exit };
  // Interval of time with the Taylor series y(t) = sum_k y_coefficients[k] t^k from its start.
  struct TaylorPanel {
    std::array<double, kTaylorOrder + 1> y_coefficients;
    double duration;  // negative if the trajectory is traced backward in time
    PhaseState end_state;
    PanelEnd end_kind = PanelEnd::interior;
    bool is_smooth_in_square_root;  // whether integrands are smooth in sqrt(barrier - y)

    PhaseState state_at(double time) const;
  };
  struct PanelLimit {
    double max_duration;
    bool is_smooth_in_square_root;
  };

  bool is_at_rest(const PhaseState& state) const;
  std::array<double, kTaylorOrder + 1> taylor_coefficients(const PhaseState& start) const;
  // The direction is 1 forward in time, -1 backward in time.
  PanelLimit find_taylor_panel_limit(const PhaseState& start, int direction) const;
  TaylorPanel compute_next_taylor_panel(const PhaseState& start, double max_duration,
                                        int direction) const;
  static double find_time_at_displacement(const TaylorPanel& panel, double y, double guess);
  void append_quadrature_nodes(const PhaseState& start, const TaylorPanel& panel, double time,
                               std::vector<TrajectoryQuadratureNode>& nodes) const;
  template <class Visitor>
  void visit_taylor_panels_backward(PhaseState end, double max_duration, double max_speed,
                                    const Visitor& visit) const;

  problem::System system_;
  double barrier_;
  BarrierKind barrier_kind_;
  double displacement_scale_, velocity_scale_, panel_refinement_;
};

}  // namespace fpkcheck::backward
