#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::problem {
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Sparse matrix of compressed columns with 32-bit indices, the input format of KLU. With 64-bit
/// indices the solution of triangular systems by KLU would read a third more memory.
using SparseColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor>;

/// Term A (x) E of velocity jumps, with A acting on x1, shape (nx, nx), and E on x2, shape (nv,
/// nv).
struct NonlocalExcitationTerm {
  std::optional<AxisOperator> of_x1;  ///< A; absent for the identity
  Eigen::MatrixXd of_x2;
};

/// Semi-discrete equation dP/dt = L P for the cell averages P of p(y, y') on the half-plane, with L
/// = local + sum A (x) E. The operator L conserves mass: the row vector of cell areas times L is
/// zero.
struct FokkerPlanckOperator {
  SparseColumnMatrix
      local;  ///< terms of transport, impact, drift and diffusion; shape (size, size)
  std::vector<NonlocalExcitationTerm> exchange;  ///< one term unless the impulses are parametric
  Eigen::VectorXd areas;

  Eigen::VectorXd operator*(const Eigen::VectorXd& cell_averages) const;
  /// Returns the product of the transposed operator with a vector.
  Eigen::VectorXd transposed_product(const Eigen::VectorXd& x) const;
  /// Returns the whole operator as one sparse matrix, without rounding errors of `exchange`.
  SparseColumnMatrix assembled_matrix() const;
  /// Returns the largest rate of mass loss of the operator in a cell, from the column sums.
  double max_mass_loss_rate() const;
  double total_mass(const Eigen::VectorXd& cell_averages) const { return areas.dot(cell_averages); }
  /// Returns the stationarity residual ||L P||_1 / ||P||_1 of the cell averages P, per unit time.
  double stationarity_residual(const Eigen::VectorXd& cell_averages) const;
};

/// Rule that computes the cell averages of x2 p, and of the force times p, from cell averages of p.
/// The rule `full` averages over several cells and has the order of accuracy of the operator. The
/// rule `lumped` multiplies the cell average of p by the value of x2, or of the force, at the cell
/// centre, and is accurate to second order.
enum class CellAverageProductRule { full, lumped };

/// Returns the operator of paper (15) with the given excitation, and with the impact condition at
/// each wall. A right end of the axis x1 with the condition `barrier` absorbs the motion that
/// reaches this end:
///
///     p_t = -x2 p_1 + d/dx2 [ (c(x1) x2 + c_vv x2^3 + g(x1)) p ] + excitation,
///
/// Here g is the restoring force, and c(x1) and c_vv are the damping coefficients of `system`.
///
/// @param impact map or delta
/// @param scheme_order order of accuracy of the transport terms; odd orders have upwind-biased
/// stencils, even orders centred stencils. The derivatives of the excitation have centred stencils
/// of the next even order.
FokkerPlanckOperator fokker_planck_operator(
    const problem::System& system, const DiscretisedExcitation& excitation,
    problem::ImpactCondition impact, const PhasePlaneGrid& grid, int scheme_order,
    CellAverageProductRule averaging = CellAverageProductRule::full);

/// Returns the matrix that maps cell averages to the flux of probability into a wall, shape (nv/2,
/// nx nv). Row i gives the average of u p(0+, -u), or of u p(b-, u) at a second wall x1 = b, over
/// cell i of the axis of the speed u.
SparseColumnMatrix wall_flux_matrix(const PhasePlaneGrid& grid, int scheme_order,
                                    AxisEnd end = AxisEnd::left);

/// Returns the matrix factor A + shift I, with the identity matrix I.
SparseColumnMatrix scale_and_shift_matrix(double factor, const SparseColumnMatrix& matrix,
                                          double shift);

}  // namespace fpkcheck::fd_fpk
