#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "fd_fpk/functionals/backward_excitation.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "problem/effective_potential.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::fd_fpk {

/// Finite differences of the generator of the backward equation on the states below an energy level
/// H, v^2/2 + U(y) < H,
///
///     L T = v T_y - f(y, v) T_v + a T_v + D T_vv + lambda (E[T(y, v + Y)] - T),
///
/// where T is 0 on and above the level, and a is the mean force of the excitation (its drift). The interval of y has turning points of the level, or
/// walls, at its ends. The coordinates are a phase s in (0, 1) and eta = v / w(y), with the speed
/// w = sqrt(2 (H - U)) on the level. At a turning point y depends on the square of the distance in
/// s, and T(-s, -eta) = T(s, eta) continues T as a smooth function. The level therefore is a line
/// of the grid, and T is smooth up to the level also where T jumps there (under impulses alone).
/// The nodes are equidistant in s and Chebyshev points in eta. The differences along the motion are
/// upwind-biased, of order 5, and of order 3 next to a wall and next to a turning point.
class EnergyLevelGrid {
 public:
  /// @param system,potential must outlive this object; `potential` is that of `system`
  /// @param interval the interval of y in which U < `level`
  /// @param velocity_count even number of nodes in eta
  EnergyLevelGrid(const problem::System& system, const problem::EffectivePotential& potential,
                  const problem::HalfCycle& interval, double level, int displacement_count,
                  int velocity_count, const BackwardEquationExcitation& excitation);

  int displacement_count() const { return n_s_; }
  int velocity_count() const { return static_cast<int>(eta_.size()); }
  int size() const { return n_s_ * velocity_count(); }
  /// Returns the index of node (i, j) in vectors.
  int grid_node_index(int i, int j) const { return i * velocity_count() + j; }
  double displacement(int i) const { return y_[i]; }
  double velocity(int i, int j) const { return w_[i] * eta_[j]; }
  /// Returns the largest speed below the level at the displacement y; 0 outside the interval of y.
  double speed_on_level(double y) const;

  /// Returns the matrix of the backward equation, shape (size, size).
  SparseColumnMatrix backward_matrix() const;
  /// Returns the weights of the nodes in the integral over y and v below the level.
  Eigen::VectorXd integration_weights() const;
  /// Returns the weights of the nodes in the value T(y, v) of a state below the level. At a wall
  /// the velocity is that before an impact or after an impact.
  /// @pre abs(v) < speed_on_level(y)
  Eigen::VectorXd interpolation_weights_at_state(double y, double v) const;
  /// Returns the weights of the nodes in the mean E[T] right after an impulse on a mass at rest at
  /// the displacement y.
  Eigen::VectorXd mean_after_impulse_weights(double y) const;

 private:
  using Entries = std::vector<std::pair<int, double>>;  // nodes and weights

  double displacement_at(double s) const;
  double displacement_slope(double s) const;  // dy/ds
  double phase_of(double y) const;
  // Position of column k in s. The columns -3 .. -1 and n .. n + 2 are reflected columns beyond a
  // turning point; the columns -1 and n are the wall at an end with a wall.
  double column_position(int k) const;
  int first_column(bool with_wall) const;
  int last_column(bool with_wall) const;
  void add_interpolated_value(int column, double eta, double weight, Entries& entries) const;
  void add_node_value(int column, int j, double weight, Entries& entries) const;
  void add_value_at_wall(bool left, double eta, double weight, Entries& entries) const;
  void add_value_in_column(int i, double eta, double weight, int first, int last,
                           Entries& entries) const;
  void add_value_at_phase(double s, double eta, double weight, Entries& entries) const;
  void add_eta_derivative(int i, int j, int order, double weight, int first, int last,
                          Entries& entries) const;
  void add_impulses(int i, int j, Entries& entries) const;

  const problem::System& system_;
  const problem::EffectivePotential& potential_;
  problem::HalfCycle interval_;
  double level_;
  int n_s_;
  BackwardEquationExcitation excitation_;
  std::vector<double> y_, w_;  // displacements, and speeds on the level
  std::vector<double> eta_;
  // Whether T is 0 at eta = -1 and at eta = 1: under diffusion, or where the motion crosses the
  // level
  std::vector<std::array<bool, 2>> vanishes_;
};

}  // namespace fpkcheck::fd_fpk
