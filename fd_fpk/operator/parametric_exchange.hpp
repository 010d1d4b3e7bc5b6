#pragma once

#include <vector>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the operator terms of the velocity jumps b(x1) Y of parametric impulses with the
/// amplitude Y. The matrix E(b) of the velocity jumps b Y is interpolated between values b_m of the
/// factor b, by polynomials of degree 5 on the six values b_m around b(x1),
///
///     sum_m A_m (x) E(b_m),
///
/// where the matrix A_m averages the product of the m-th Lagrange polynomial at b(x1) and of the
/// density over the cells of x1. The velocity jumps for neighbouring values b_m of the factor b(x1)
/// differ by about one cell of x2.
/// @param weight_stencil_size number of cells in each finite-volume stencil of the displacement x1
std::vector<NonlocalExcitationTerm> parametric_exchange_terms(const ParametricImpulses& impulses,
                                                              const PhasePlaneGrid& grid,
                                                              int weight_stencil_size);

}  // namespace fpkcheck::fd_fpk
