#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <vector>

#include "backward/passage/unforced_motion.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Tensor product of Chebyshev nodes in y or in sqrt(y_high - y), and in v, for the interpolation
/// of functions on the phase plane. Outside the domain of the grid an interpolated function is
/// constant along y and along v.
class ChebyshevGrid {
 public:
  /// Rectangle y_low <= y <= y_high, |v| <= v_max of the phase plane
  struct Domain {
    double y_low, y_high, v_max;
    /// Whether y_high is an absorbing barrier. The functions are then smooth in sqrt(y_high - y).
    bool ends_at_barrier = true;
  };
  ChebyshevGrid(const Domain& domain, int y_node_count, int v_node_count);

  int y_node_count() const { return static_cast<int>(y_interpolation_.size()); }
  int v_node_count() const { return static_cast<int>(v_interpolation_.size()); }
  /// Returns the number of nodes (y, v) of the tensor product.
  Eigen::Index node_count() const { return y_interpolation_.size() * v_interpolation_.size(); }
  const Domain& phase_plane_domain() const { return domain_; }
  double y_node(int i) const {
    const double x = y_interpolation_.nodes(i);
    return domain_.y_high - (domain_.ends_at_barrier ? x * x : x);
  }
  double v_node(int j) const { return v_interpolation_.nodes(j); }
  /// Returns the index of the node (y_node(i), v_node(j)) in a vector of the values of a function
  /// at all nodes.
  Eigen::Index node_index(int i, int j) const { return i * v_interpolation_.size() + j; }

  /// Evaluates the Lagrange polynomials a_i(y) of the nodes in y, or b_j(v) of the nodes in v. A
  /// function with the values g_ij at the nodes has the interpolated value sum_ij a_i(y) g_ij
  /// b_j(v).
  /// @param[out] values values of all polynomials, shape (number of nodes in y or in v)
  void evaluate_y_polynomials(double y, Eigen::Ref<Eigen::VectorXd> values) const;
  void evaluate_v_polynomials(double v, Eigen::Ref<Eigen::VectorXd> values) const;

 private:
  struct BarycentricInterpolation {
    Eigen::VectorXd nodes, barycentric_weights;

    BarycentricInterpolation(double low, double high, int count);
    Eigen::Index size() const { return nodes.size(); }
    void evaluate_lagrange_polynomials(double x, Eigen::Ref<Eigen::VectorXd> values) const;
  };
  Domain domain_;
  BarycentricInterpolation y_interpolation_;  // in y_high - y or in sqrt(y_high - y)
  BarycentricInterpolation v_interpolation_;
};

/// Weight function w(t) = t^time_power exp(-decay_rate t) of the time t since the last impulse.
struct TimeSinceImpulseWeight {
  double decay_rate;
  int time_power = 0;
};

/// Map z(x) from x in [0, 1] to an interval of velocities or displacements z. The slope z'(x) is 0
/// at the ends of the interval at which integrals along trajectories are not smooth.
struct IntervalMap {
  double begin, length;
  bool is_smooth_at_begin, is_smooth_at_end;

  double value(double x) const;
  double slope(double x) const;
};

/// Interval [begin, end] of x with the Gauss points in x, as nodes of the interpolation in x.
struct VelocityQuadraturePanel {
  static constexpr unsigned kPoints = 10;
  IntervalMap map;
  double begin, end;
  std::vector<double> nodes, weights;  ///< points and weights of the Gauss rule
};

/// Discretisation of the operator A, the mean over an impulse Y of the integral of a function f
/// along the motion after the impulse,
///
///     (A f)(y, v) = E int_0^te w(t) f(X_t) dt,   X_0 = (y, v + Y),
///
/// where te is the time at which the motion passes the barrier without a further impulse, or
/// infinity. Let h(y, v) = E T(y, v + Y) be the mean time to the passage after an impulse. With the
/// weight w(t) = exp(-lambda t) the function h satisfies the renewal equation
///
///     h = A 1 + lambda A h.
///
/// Collocation represents f and A f by their values at the nodes of a ChebyshevGrid.
class RenewalEquation {
 public:
  /// @param min_decay_rate smallest decay rate of the weights of compute_operators() and
  /// integrate_from_state(), which limits the durations of the trajectories
  /// @param panel_refinement factor by which the panels of the quadrature rules in time and in
  /// velocity are shorter than with the factor 1
  /// @param barrier displacement at which trajectories end; infinity without a barrier
  /// @param barrier_kind whether the trajectories on which integrals are not smooth end at the
  /// barrier
  /// @pre the impulses have an amplitude law with a density, and no factor
  RenewalEquation(const problem::Problem& problem, const ChebyshevGrid& grid, double min_decay_rate,
                  double panel_refinement, double barrier, BarrierKind barrier_kind);
  /// Equation for an absorbing barrier at the upper end of the grid
  RenewalEquation(const problem::Problem& problem, const ChebyshevGrid& grid, double min_decay_rate,
                  double panel_refinement)
      : RenewalEquation(problem, grid, min_decay_rate, panel_refinement,
                        grid.phase_plane_domain().y_high, BarrierKind::absorbing) {
    assert(grid.phase_plane_domain().ends_at_barrier);
  }

  /// The discretised operator A of one weight function.
  struct MotionIntegralOperator {
    Eigen::MatrixXd matrix;         ///< maps values of f to values of A f, shape (nodes, nodes)
    Eigen::VectorXd values_of_one;  ///< values of A 1, the function A f for f = 1
  };
  /// Computes the operators of several weights. The result is empty if the deadline passes.
  std::vector<MotionIntegralOperator> compute_operators(
      const std::vector<TimeSinceImpulseWeight>& weights, const base::Deadline& deadline) const;

  /// Computes the same operators with the values of A f at the states (displacements[i], v_j) in
  /// place of the nodes of the grid, where v_j are the nodes in v of the grid.
  std::vector<MotionIntegralOperator> compute_operators_at(
      const std::vector<double>& displacements, const std::vector<TimeSinceImpulseWeight>& weights,
      const base::Deadline& deadline) const;

  /// The linear form f -> int_0^te w(t) f(X_t) dt of the motion from one state.
  struct MotionIntegral {
    Eigen::VectorXd node_weights;  ///< coefficients of the values of f at the nodes of the grid
    double integral_of_one;        ///< value of the linear form for f = 1, int_0^te w(t) dt
  };
  MotionIntegral integrate_from_state(const PhaseState& start,
                                      const TimeSinceImpulseWeight& weight) const;

  /// Quadrature rule for the mean over an impulse of a function g of the velocity. For each node
  /// v_j of the grid, E g(v_j + Y) = sum_q weights(j, q) g(velocities[q]).
  struct VelocityQuadrature {
    std::vector<double> velocities;
    Eigen::MatrixXd weights;
  };
  VelocityQuadrature make_velocity_quadrature(double y) const;

  /// Divides an interval of velocities into panels in which integrals along the trajectory from
  /// (y, v) are smooth functions of v.
  std::vector<VelocityQuadraturePanel> divide_velocities_into_panels(double y, double low,
                                                                     double high) const;

  /// Computes the linear forms f -> int_0^te w(t) f(X_t) dt of several weights w along a
  /// trajectory. If the trajectory does not pass the barrier, the state remains the last state of
  /// the trajectory until t = infinity.
  /// @param[out] node_weights coefficients of the values of f at the nodes of the grid, one matrix
  /// of shape (nodes in y, nodes in v) for each weight; the matrices are in consecutive columns
  /// @param[out] integrals_of_one value of each linear form for f = 1
  void integrate_along_trajectory(const UnforcedTrajectory& trajectory,
                                  const std::vector<TimeSinceImpulseWeight>& weights,
                                  Eigen::Ref<Eigen::MatrixXd> node_weights,
                                  Eigen::Ref<Eigen::VectorXd> integrals_of_one) const;

  const ChebyshevGrid& grid() const { return grid_; }
  const UnforcedMotionSolver& motion_solver() const { return motion_solver_; }
  double max_duration() const { return max_duration_; }
  /// Returns the range of velocities after an impulse at a node.
  std::array<double, 2> velocity_range() const;

 private:
  std::vector<double> find_velocities_of_nonsmooth_integrals(double y) const;

  problem::Problem problem_;
  ChebyshevGrid grid_;
  double barrier_, panel_refinement_;
  UnforcedMotionSolver motion_solver_;
  double max_duration_;  // longest duration of a trajectory; afterwards the weights are < 1.5e-8
  double min_amplitude_, max_amplitude_;  // effective_amplitude_range()
};

/// Returns the range of amplitudes outside of which the probability is below 1e-9.
/// @return lower and upper end of the range
std::array<double, 2> effective_amplitude_range(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::backward
