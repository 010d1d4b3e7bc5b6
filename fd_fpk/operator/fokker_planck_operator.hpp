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

/// Excitation term A (x) E of velocity jumps: a Kronecker product of a matrix A for the
/// displacement x1, shape (nx, nx), and a matrix E for the velocity x2, shape (nv, nv).
struct NonlocalExcitationTerm {
  std::optional<AxisOperator> of_x1;  ///< A; absent for the identity
  Eigen::MatrixXd of_x2;
};

/// Semi-discrete equation dP/dt = L P for the cell averages P of p(y, y') on the half-plane, where
/// L is the sum of the sparse matrix `local` and of Kronecker products A (x) E. The operator L
/// conserves mass: the row vector of cell areas times L is zero.
struct FokkerPlanckOperator {
  SparseColumnMatrix
      local;  ///< terms of transport, impact, drift and diffusion; shape (size, size)
  std::vector<NonlocalExcitationTerm> exchange;  ///< one term unless the impulses are parametric
  Eigen::VectorXd areas;

  Eigen::VectorXd operator*(const Eigen::VectorXd& cell_averages) const;
  Eigen::VectorXd transposed_product(const Eigen::VectorXd& x) const;
  /// Returns the whole Fokker-Planck operator as one sparse matrix, without those entries of
  /// `exchange` that are only rounding errors.
  SparseColumnMatrix assembled_matrix() const;
  /// Returns the largest rate at which a cell loses mass, computed from the column sums of L.
  double max_mass_loss_rate() const;
  double total_mass(const Eigen::VectorXd& cell_averages) const { return areas.dot(cell_averages); }
  /// Returns the stationarity residual ||L P||_1 / ||P||_1 of the cell averages P, per unit time.
  double stationarity_residual(const Eigen::VectorXd& cell_averages) const;
};

/// Rule that computes the cell averages of x2 p, and of the force times p, from cell averages of p.
/// The product rule `full` averages over several cells and has the order of accuracy of the
/// Fokker-Planck operator. The product rule `lumped`, of second order, multiplies the cell average
/// of the density p by the value of x2, or of the force, at the cell centre.
enum class CellAverageProductRule { full, lumped };

/// Returns the discretised operator of the density equation (15) of the paper, with the given
/// excitation and the impact condition at each wall. A right end of the x1 axis with the end
/// condition `barrier` absorbs the motion that reaches the right end:
///
///     p_t = -x2 p_1 + d/dx2 [ (c(x1) x2 + c_vv x2^3 + g(x1)) p ] + excitation,
///
/// In the density equation, g is the restoring force, and c(x1) and c_vv are the damping
/// coefficients of `system`.
///
/// @param impact impact condition, `map` or `delta`
/// @param scheme_order order of accuracy of the transport terms; odd orders have upwind-biased
/// stencils, even orders centred stencils. The derivatives of the excitation terms have centred
/// stencils of the next even order.
FokkerPlanckOperator fokker_planck_operator(
    const problem::System& system, const DiscretisedExcitation& excitation,
    problem::ImpactCondition impact, const PhasePlaneGrid& grid, int scheme_order,
    CellAverageProductRule averaging = CellAverageProductRule::full);

/// Returns the matrix, shape (nv/2, nx nv), that maps cell averages to the probability flux into a
/// wall. Row i gives the average over speed cell i of the flux u p(0+, -u) at the speed u, or of u
/// p(b-, u) at a second wall x1 = b.
SparseColumnMatrix wall_flux_matrix(const PhasePlaneGrid& grid, int scheme_order,
                                    AxisEnd end = AxisEnd::left);

/// Returns the matrix factor * A + shift * I, with the given matrix A and the identity matrix I.
SparseColumnMatrix scale_and_shift_matrix(double factor, const SparseColumnMatrix& matrix,
                                          double shift);

}  // namespace fpkcheck::fd_fpk
