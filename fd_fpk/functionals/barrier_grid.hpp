#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "fd_fpk/functionals/backward_excitation.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Part of the phase plane below a displacement barrier, or between two displacement barriers.
struct PassageStrip {
  /// Lower end of y: a wall, an absorbing barrier, or the end of a computational box at which the
  /// density is negligible. The box end reflects the motion elastically.
  enum class LowerEnd { wall, barrier, box };
  LowerEnd lower_end;
  double lower, upper;   ///< ends of y; the upper end is an absorbing barrier
  double largest_speed;  ///< T_v = 0 at v = largest_speed and at v = -largest_speed
};

/// Finite differences of the backward equation on a PassageStrip,
///
///     v T_y - f(y, v) T_v + a T_v + D G(y, v) T_vv + lambda (E[T(y, v + Y)] - T),
///     T(upper, v) = 0 for v > 0,   T(lower, v) = 0 for v < 0 at a barrier,
///     T(lower, -u) = T(lower, r u) at a wall,
///
/// where G is the squared noise factor. Under noise T is continuous, but at the point (upper, 0) of
/// a barrier T ~ (upper - y)^(1/6) (Masoliver and Porra, Phys. Rev. Lett. 75 (1995) 189), and T has
/// a singularity at (lower, 0) of an inelastic wall, too. Both singularities are functions of v /
/// d^(1/3) with the distance d from the end. The nodes are therefore equidistant in a coordinate s
/// of y with d ~ s^4 at barriers and walls, and in eta of v = V sinh(a eta) / sinh(a). The
/// differences along the motion are upwind-biased, of order 5. Next to an end the differences use
/// fewer nodes on the side of the end.
class BarrierGrid {
 public:
  /// @param problem must outlive this object
  /// @param velocity_count even number of nodes in eta
  BarrierGrid(const problem::Problem& problem, const BackwardEquationExcitation& excitation,
              const PassageStrip& strip, int displacement_count, int velocity_count);

  int displacement_count() const { return n_s_; }
  int velocity_count() const { return n_eta_; }
  int size() const { return n_s_ * n_eta_; }
  /// Returns the index of node (i, j) in vectors.
  int grid_node_index(int i, int j) const { return i * n_eta_ + j; }
  double displacement(int i) const { return displacement_at(column_position(i)); }
  double velocity(int j) const { return velocity_at(eta(j)); }
  /// Returns the weight of node j in integrals over v.
  double velocity_weight(int j) const { return velocity_slope(eta(j)) * eta_step(); }
  /// Returns the increasing edges between the nodes, and the ends.
  std::vector<double> displacement_edges() const;
  std::vector<double> velocity_edges() const;

  struct BackwardSystem {
    SparseColumnMatrix matrix;  ///< matrix A of the backward equation, shape (size, size)
    /// Vector g of the equation A u + g = 0 of the probability u that the motion leaves the strip
    /// at the upper barrier
    Eigen::VectorXd upper_exit_terms;
  };
  BackwardSystem backward_system() const;
  /// Returns the weights of the nodes in the integral over y and v. Midpoint sums in s and eta have
  /// a high order, since integrands with the factors dy/ds and dv/deta vanish at barriers and
  /// walls, and the density at the ends of the box is negligible.
  Eigen::VectorXd integration_weights() const;
  /// Returns the weights of the nodes in the value T(y, v) of a state in the strip. At a wall the
  /// velocity is that before an impact or after an impact.
  /// @pre at a barrier the velocity points into the strip
  Eigen::VectorXd interpolation_weights_at_state(double y, double v) const;
  /// Returns the weights of the nodes in the mean E[T] right after an impulse on a mass at rest at
  /// the displacement y.
  Eigen::VectorXd mean_after_impulse_weights(double y) const;

 private:
  using Entries = std::vector<std::pair<int, double>>;  // nodes and weights

  double displacement_at(double s) const;
  double displacement_slope(double s) const;  // dy/ds
  double velocity_at(double eta) const;
  double velocity_slope(double eta) const;      // dv/deta
  double velocity_curvature(double eta) const;  // d^2v/deta^2
  double eta_of(double v) const;                // between -1 and 1
  double eta(int j) const { return (j + 0.5) * eta_step() - 1; }
  double eta_step() const { return 2.0 / n_eta_; }
  // Position of column k in s. The columns -1 and displacement_count() are the ends.
  double column_position(int k) const;
  // Node of the reflection of node j about eta = -1 or eta = 1; j for a node of the grid
  int reflected_velocity_node(int j) const;
  void add_value_in_column(int i, double eta, double weight, int first, int last,
                           Entries& entries) const;
  void add_value_at_lower_end(double v, double weight, Entries& entries) const;
  // Adds the terms of the displacement, and returns the weight of the upper end.
  double add_displacement_terms(int i, int j, Entries& entries) const;
  void add_velocity_terms(int i, int j, Entries& entries) const;
  Eigen::MatrixXd impulse_matrix() const;

  const problem::Problem& problem_;
  BackwardEquationExcitation excitation_;
  PassageStrip strip_;
  int n_s_, n_eta_;
};

}  // namespace fpkcheck::fd_fpk
