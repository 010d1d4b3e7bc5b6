#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"

namespace fpkcheck::epc::contact {

/// The Galerkin equations of the impact process whose members are the functions h_p(rho) g_q(v),
/// 1 <= p + q <= n. Along a trajectory and through the impulses,
///
///     L*phi = rho' phi_rho + v' phi_v + lambda ( E[phi(y, v + Y)] - phi ),
///     rho'  = -v f / rho,    v' = -(f + g),
///
/// f the damping; at rest, the last point of the rule,
///
///     L*phi = lambda ( E[phi(0, Y); Y > 0] + E[phi(0, r |Y|); Y < 0] - phi(0, 0) ).
///
/// Among the members is rho^2/2, so that the balance of power is met.
/// @param points of the rule up to rho_max
/// @param wall_points how many the rule on the wall has
half_plane::Equations equations(const problem::Problem& problem, const Coordinates& coordinates,
                                double rho_max, const half_plane::Confinement& confinement,
                                half_plane::Basis basis, half_plane::Points points,
                                int wall_points);

}  // namespace fpkcheck::epc::contact
