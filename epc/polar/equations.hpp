#pragma once

#include <vector>

#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::polar {

/// Galerkin equations of the impact process for the functions h_p(rho) g_q(theta), 1 <= p + q <= n.
/// Flow and impulses give
///
///     L*phi = rho' phi_rho + theta' phi_theta + lambda ( E[phi(y, v + Y)] - phi ),
///     rho'   = -c rho sin^2 + (w w' - g) sin,
///     theta' = -w' sin^2 - (g/w) cos^2 - c sin cos,      sin, cos of theta.
///
/// At the origin, where phi has a jump, all terms are bounded: the mean of a basis function has a
/// finite rate of change. (For white noise there are no such equations: d^2 theta/dv^2 is not
/// integrable.) For K = k the basis contains the energy rho^2/2, and the root satisfies the energy
/// balance exactly.
/// @param points quadrature points up to the amplitude rho_max
/// @param wall_points number of quadrature points on the wall
half_plane::ClosureEquations closure_equations(const problem::Problem& problem,
                                               const Coordinates& coordinates, double rho_max,
                                               const half_plane::Confinement& confinement,
                                               half_plane::Basis basis,
                                               half_plane::QuadraturePoints points,
                                               int wall_points);

/// Amplitudes below rho_max from which an impulse, an atom of the law, may stop the mass at the
/// wall. At these amplitudes the mean of phi over the impulses has the jump that phi has at the
/// origin. The list is empty for a law without atoms.
std::vector<double> amplitude_break_points(const problem::ImpulseLaw& law, double rho_max);

}  // namespace fpkcheck::epc::polar
