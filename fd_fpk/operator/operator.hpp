#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/model.hpp"

namespace fpkcheck::problem {
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Sparse matrix of compressed columns with 64-bit indices, the input format of KLU.
using SparseColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// The semi-discrete equation dP/dt = L P for the cell averages P of p(y, y') on the half-plane, L
/// = local + 1 (x) exchange. The operator conserves mass: the row vector of cell areas times L is
/// zero, so that the mass, the sum of area times P over all cells, is constant.
struct FokkerPlanckOperator {
  SparseColumnMatrix
      local;  ///< terms of transport, impact, drift and diffusion; shape (size, size)
  /// term of the velocity jumps at fixed x1, shape (nv, nv); empty without jumps
  Eigen::MatrixXd exchange;
  Eigen::VectorXd areas;  ///< areas of the cells, shape (size)

  Eigen::VectorXd operator*(const Eigen::VectorXd& averages) const;
  /// The whole operator as one sparse matrix. Entries of `exchange` that are only rounding errors
  /// are dropped.
  SparseColumnMatrix assembled_matrix() const;
  /// The largest rate at which the operator violates the conservation of mass: the maximum over all
  /// columns of |sum of area times entry| / area of the cell of the column.
  double max_mass_loss_rate() const;
  /// Total mass of a density given by cell averages.
  double total_mass(const Eigen::VectorXd& averages) const { return areas.dot(averages); }
  /// The stationarity residual ||L P||_1 / ||P||_1, per unit time: the relative rate of change of
  /// the density with cell averages P.
  double stationarity_residual(const Eigen::VectorXd& averages) const;
};

/// The rule that computes the cell averages of x2 p, and of the force times p, from cell averages
/// of p. `full`: to the order of the operator, from several cells. `lumped`: the cell average of p
/// times x2 or the force at the centre of the cell, which is accurate to second order and uses no
/// neighbouring cells.
enum class ProductAveraging { full, lumped };

/// The operator of paper (15) with the chosen excitation, and with the impact condition at each
/// wall at an end of x1:
///
///     p_t = -x2 p_1 + d/dx2 [ (c(x1) x2 + c_vv x2^3 + g(x1)) p ] + excitation,
///
/// with the restoring force g of `system`, and its damping coefficients c(x1) and c_vv.
///
/// @param impact map or delta
/// @param scheme_order order of accuracy of the transport terms: odd orders have upwind-biased
/// stencils, even orders centred stencils. The derivatives of the excitation have centred stencils
/// of the next even order.
FokkerPlanckOperator fokker_planck_operator(const problem::System& system,
                                            const Excitation& excitation, problem::Impact impact,
                                            const Grid& grid, int scheme_order,
                                            ProductAveraging averaging = ProductAveraging::full);

/// The flux of probability into a wall as a matrix on P, shape (nv/2, nx nv). Row i of the product
/// is the average of u p(0+, -u), or of u p(b-, u) at the end b, over cell i of the axis of the
/// speed u into the wall, with u increasing from 0.
SparseColumnMatrix wall_flux_matrix(const Grid& grid, int scheme_order,
                                    AxisEnd end = AxisEnd::left);

/// Returns the matrix factor A + shift I, with the identity matrix I.
SparseColumnMatrix scale_and_shift(double factor, const SparseColumnMatrix& a, double shift);

}  // namespace fpkcheck::fd_fpk
