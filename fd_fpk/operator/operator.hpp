#pragma once

#include <Eigen/SparseCore>
#include <cstdint>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "problem/model.hpp"

namespace fpkcheck::problem {
class System;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

/// Compressed sparse columns with 64-bit indices, the input format of KLU.
using SparseColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// The semi-discrete equation dP/dt = L P for the cell averages P of p(y, y') on the half-plane, L
/// = local + 1 (x) exchange. Conservative: the areas of the cells times L is zero, so that the
/// mass, the sum of area times P, is constant.
struct FokkerPlanckOperator {
  SparseColumns local;       ///< transport, impact, drift and diffusion; shape (size, size)
  Eigen::MatrixXd exchange;  ///< jumps of the velocity at fixed x1, shape (nv, nv), or empty
  Eigen::VectorXd areas;     ///< of the cells, shape (size)

  Eigen::VectorXd operator*(const Eigen::VectorXd& averages) const;
  /// The whole operator as one sparse matrix, without exchange entries at the level of rounding.
  SparseColumns assembled() const;
  /// Largest |sum over the column of area times entry| / area: the largest rate of mass loss.
  double leak() const;
  /// Mass of cell averages.
  double mass(const Eigen::VectorXd& averages) const { return areas.dot(averages); }
  /// ||L P||_1 / ||P||_1, per unit time: the relative rate of change of a density that is not
  /// stationary.
  double residual(const Eigen::VectorXd& averages) const;
};

/// Averages of x2 p and of the force times p over a cell from averages of p. full: to the order of
/// the operator. lumped: the product with the value at the centre, of second order and without
/// neighbours.
enum class Weighting { full, lumped };

/// Paper (15) with the chosen excitation, and the impact at the walls at the ends of x1, if any,
///
///     p_t = -x2 p_1 + d/dx2 [ (c(x1) x2 + c_vv x2^3 + g(x1)) p ] + excitation,
///
/// with g the restoring force of System, and c(x1), c_vv its damping.
///
/// @param impact map or delta
/// @param order of the transport terms: odd orders have upwind-biased stencils, even orders centred
/// stencils. The derivatives of the excitation are centred, of the next even order.
FokkerPlanckOperator fokker_planck_operator(const problem::System& system,
                                            const Excitation& excitation, problem::Impact impact,
                                            const Grid& grid, int order,
                                            Weighting weighting = Weighting::full);

/// An end of x1.
enum class End { left, right };

/// Averages of u p(0+, -u), or of u p(b-, u) at the end b, over the cells of the speed u of
/// particles moving into the wall, in increasing order, as a matrix on P, shape (nv/2, nx nv): the
/// flux of probability into the wall.
SparseColumns wall_flux(const Grid& grid, int order, End end = End::left);

/// factor A + shift 1.
SparseColumns scale_and_shift(double factor, const SparseColumns& a, double shift);

}  // namespace fpkcheck::fd_fpk
