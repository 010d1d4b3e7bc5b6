#pragma once

#include <vector>

#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::polar {

/// The Galerkin equations of the impact process whose members are the functions h_p(rho)
/// g_q(theta), 1 <= p + q <= n. Along a trajectory and through the impulses,
///
///     L*phi = rho' phi_rho + theta' phi_theta + lambda ( E[phi(y, v + Y)] - phi ),
///     rho'   = -c rho sin^2 + (w w' - g) sin,
///     theta' = -w' sin^2 - (g/w) cos^2 - c sin cos,      sin, cos of theta,
///
/// all bounded at the origin, where phi jumps: a member has a mean, and its mean a rate of change,
/// as that of a polynomial has. (White noise has no such equations: d^2 theta/dv^2 is not
/// integrable.) Among the members is rho^2/2, so that the balance of energy is met.
/// @param points of the rule up to rho_max
/// @param wall_points how many the rule on the wall has
half_plane::Equations equations(const problem::Problem& problem, const Coordinates& coordinates,
                                double rho_max, const half_plane::Confinement& confinement,
                                half_plane::Basis basis, half_plane::Points points,
                                int wall_points);

/// Amplitudes below rho_max from which an impulse may stop the mass at the wall: there the mean
/// over an atom of the law jumps as phi does at the origin. None for a law with a density.
std::vector<double> breaks_of(const problem::ImpulseLaw& law, double rho_max);

}  // namespace fpkcheck::epc::polar
