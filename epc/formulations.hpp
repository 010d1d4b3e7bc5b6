#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

/// The solvers of the formulations, for epc::solve(). The options have been validated.
namespace fpkcheck::epc {

/// The paper's closure: p(z, z') = C exp(Q_n) on the whole plane, with the projections (23) under
/// the Gaussian weights (25)-(26).
namespace gaussian {

/// Solves the formulation `gaussian` for epc::solve(), with validated options: solves (23) by
/// find_root() and assesses the root. The status is
///  - ok if the density on the whole edge of its support is below kEdgeDensityLimit of its peak,
///    the mass is within kMassTolerance of 1, and the residual of the energy balance is below
///    kEnergyResidualLimit. If the density of order n-2 has decayed on its edge, the distance to
///    this density must also be below kOrderDistanceLimit;
///  - inadmissible if the density of the root violates one of these conditions. The result still
///    contains the density and the coefficients;
///  - not_converged if no root was found, or if for `kf` the root depends on the disc of
///    JumpIntegralRemainder. The result has no density.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace gaussian

/// Closure with exact moment equations: p(y, v) = C exp(Q_n(y, v)) between the walls (y >= 0 for
/// the paper's oscillator), with all monomials of degree 1 .. n. The density satisfies the moment
/// equations of the impact process for every polynomial of degree up to n. The series (15) is not
/// truncated, and the impact condition (2) is not approximated. The only approximation is the form
/// of the exponent.
namespace moment {

/// Solves the formulation `moment` for epc::solve(), with validated options. The status is
///  - ok if the density satisfies the equations and has decayed to kEdgeDensityLimit of its peak on
///    the edge of its support, and exp(Q_n) to kLevelDensityLimit at the confinement level.
///    half_plane::set_status() has further conditions;
///  - inadmissible if the density of the root violates one of these conditions;
///  - not_converged if Newton's method and the homotopy failed, or if the quadrature did not
///    converge.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace moment

/// Closure in amplitude and phase: p(y, v) = C exp(Q_n(rho, theta)) on y >= 0, Q_n a polynomial of
/// degree n in polar::Coordinates. The means of all products rho^p theta^q, 1 <= p + q <= n, are
/// stationary under the exact impact process. The number of unknowns is the same as in the
/// formulation moment. Unlike the formulation moment, this closure represents the jump of the
/// density at the origin, and the features that rare impulses cause near the origin.
namespace polar {

/// Solves the equations of the formulation polar and assesses the root. The status is
///  - ok if the density satisfies the equations and has decayed to 1e-4 of its peak at the
///    confinement level (kLevelDensityLimit);
///  - inadmissible if the density of the root has not decayed to 1e-4 of its peak at the
///    confinement level. The result still contains the density and the coefficients;
///  - not_converged if no root was found, or if the quadrature does not resolve the root.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace polar

namespace contact {

/// Solves the closure for a mass that comes to rest in contact with a wall. The solution is a
/// density C exp(Q_n(rho, v) + confinement) / e with an atom, see Coordinates. The coefficients of
/// Q_n satisfy the exact equations for the means of the basis functions.
/// @pre is_pressed_on_one_wall(problem)
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace contact

}  // namespace fpkcheck::epc
