#pragma once

#include <vector>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/galerkin_system.hpp"
#include "epc/moment/energy_domain.hpp"

namespace fpkcheck::epc::moment {

/// Returns the exact moment equations of the impact process, which are Galerkin equations: The
/// projection functions of the Galerkin equations are the polynomials phi of the basis. The
/// generator L* of the impact process between impacts is
///
///     L*phi = v phi_y - (f(y, v) + g(y)) phi_v + D G(y, v) phi_vv
///             + sum_{j=1}^n lambda E[Y^j]/j! d^j phi/dv^j,
///
/// with the noise coefficient D and the square G of the noise factor. Formulas of the force f + g,
/// the factor G and the restitution coefficient r are evaluated at the quadrature points. The sum
/// over the impulse moments E[Y^j] is finite, since the basis function phi is a polynomial. Each
/// wall adds an impact term. For a right wall at y = b the impact term is
///
///     int_{v>0} v p(b,v) [phi(b,-r v) - phi(b,v)] dv,    r = r(v).
///
/// @param rate_times_moment products lambda E[Y^j] for j = 0 .. n; entry 0 is unused, and entries
///   that the excitation lacks are 0
/// @param points quadrature points of the domain
/// @param wall_points number of quadrature points on each wall
half_plane::ClosureEquations closure_equations(
    const problem::Problem& problem, const std::vector<double>& rate_times_moment,
    const EnergySublevelSet& domain, const half_plane::ExponentConfinementTerm& confinement,
    half_plane::OrthonormalBasis basis, half_plane::QuadraturePoints points, int wall_points);

}  // namespace fpkcheck::epc::moment
