#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"

namespace fpkcheck::epc::contact {

/// Galerkin equations of the impact process for the functions h_p(rho) g_q(v), 1 <= p + q <= n.
/// Flow and impulses give
///
///     L*phi = rho' phi_rho + v' phi_v + lambda ( E[phi(y, v + Y)] - phi ),
///     rho'  = -v f / rho,    v' = -(f + g),
///
/// where f is the damping force. At the last quadrature point, where the mass is at rest in
/// contact,
///
///     L*phi = lambda ( E[phi(0, Y); Y > 0] + E[phi(0, r |Y|); Y < 0] - phi(0, 0) ).
///
/// The basis contains rho^2/2: the root satisfies the balance of power exactly.
/// @param points quadrature points up to the amplitude rho_max
/// @param wall_points number of quadrature points on the wall
half_plane::ClosureEquations closure_equations(const problem::Problem& problem,
                                               const Coordinates& coordinates, double rho_max,
                                               const half_plane::Confinement& confinement,
                                               half_plane::Basis basis,
                                               half_plane::QuadraturePoints points,
                                               int wall_points);

}  // namespace fpkcheck::epc::contact
