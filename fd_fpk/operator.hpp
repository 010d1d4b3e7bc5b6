#pragma once

#include <Eigen/SparseCore>

#include "fd_fpk/excitation.hpp"
#include "fd_fpk/grid.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Compressed sparse columns with 64-bit indices, as KLU and CVODE take them.
using SparseColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// The semi-discrete equation dP/dt = L P for the cell averages P of p(y, y') on the half-plane:
/// paper (15) with the chosen excitation and the exact impact on the wall x1 = 0,
///
///     p_t = -x2 p_1 + d/dx2 [ (c x2 + k x1 + mu x1^3) p ] + excitation,
///     p(0, w) = p(0, -w/r) / r^2  for w > 0.
///
/// Conservative: every term is a difference of fluxes or an exchange between cells, so columns sum
/// to zero and the mass, the sum of P over the cells, is kept.
///
/// @param order of the transport terms: odd orders take their stencils from upstream, even ones are
///        centred. The excitation's derivatives are centred, of the next even order.
SparseColumns fokker_planck_operator(const problem::System& system, const Excitation& excitation,
                                     const Grid& grid, int order);

/// Averages of u p(0+, -u) over the cells of outgoing speed u in increasing order, as a matrix on
/// P, shape (nv/2, nx nv): the flux of probability into the wall.
LineOperator wall_flux(const Grid& grid, int order);

}  // namespace fpkcheck::fd_fpk
