#pragma once

#include <vector>

#include "epc/form/closure_over_time.hpp"
#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

/// Solvers of the formulations of the closure; the function epc::solve_closure() validates the
/// options and calls the solvers.
namespace fpkcheck::epc {

/// The paper's closure p(z, z') = C exp(Q_n) on the whole plane, with the projections of equation
/// (23) of the paper under the Gaussian weights (25)-(26).
namespace gaussian {

/// Solves the projected equations (23) of the paper, and accepts or rejects the root by limits such
/// as kMaxSupportEdgeDensity and kMaxClosureEnergyResidual (epc/summary.hpp). For the equation `kf`
/// (full jump integral), a root that changes with the disc of JumpIntegralRemainder is discarded.
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

/// Computes the density over time by the projections (23) of the paper, applied to the
/// time-dependent density equation. With p = C(t) exp(Q_n(a(t))) and the residual F of the paper,
/// the density equation dp/dt = L p is dQ_n/dt + d ln C/dt = F. The projections of the density
/// equation on the basis functions phi_s under the Gaussian weight w are
///
///     M(a) da/dt = R(a),   M_sk = <phi_s phi_k>_w - <phi_s>_w E_p[phi_k],   R_s = <F phi_s>_w,
///
/// since d ln C/dt = -sum_k E_p[phi_k] da_k/dt keeps the total probability 1. A stationary solution
/// satisfies (23). CVODE integrates the coefficients a of the polynomial Q_n over time.
///
/// The status is `inadmissible` if, at an output time, the density on the edge of its support
/// exceeds kMaxSupportEdgeDensity of its peak. The status is `not_converged` if CVODE fails or the
/// matrix M is singular, for example for a density much wider than the Gaussian weight.
/// @pre with a wall, the means of the initial density are 0; the equation is white or km4; the
///   excitation is constant
ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request);

}  // namespace gaussian

/// Closure p(y, v) = C exp(Q_n(y, v)) between the walls, with all monomials of degree 1 .. n in the
/// polynomial Q_n. The closure density satisfies the exact moment equations of the impact process
/// for every polynomial of degree up to the closure order n. The polynomial form of the exponent is
/// the only approximation of the closure in y and v. The moment equations contain the complete
/// Kramers-Moyal series (15) of the paper and the exact impact condition (2).
namespace moment {

/// Solves the exact moment equations for the polynomial Q_n of y and v, and decides whether the
/// root is accepted. The status `ok` requires that the density on the edge of its support is at
/// most kMaxSupportEdgeDensity of its peak, and that exp(Q_n) at the confinement level is at most
/// kLevelDensityLimit of its peak. The function half_plane::set_status() checks further conditions
/// of the status `ok` of a closure.
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

/// Computes the closure density over time by half_plane::solve_evolution().
ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request);

}  // namespace moment

/// Closure p(y, v) = C exp(Q_n(rho, theta)) on y >= 0 in the amplitude rho and the phase theta of
/// polar::AmplitudePhaseCoordinates. The means of all products rho^p theta^q, 1 <= p + q <= n, of
/// amplitude and phase are stationary under the exact impact process. Unlike the closure in y and v
/// (`moment`), the closure in amplitude and phase represents the jump of the density at y = v = 0.
namespace polar {

/// Solves the exact moment equations for a polynomial Q_n of amplitude and phase, and decides
/// whether the root is accepted. The status `ok` requires that the closure density decays to 1e-4
/// of its peak at the confinement level.
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

/// Computes the closure density over time by half_plane::solve_evolution().
ClosureEvolution solve_evolution(const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request);

}  // namespace polar

namespace contact {

/// Solves the closure equations for a mass that can rest in contact with a wall. The closure
/// density is C exp(Q_n(rho, v) + confinement term) divided by the energy, with amplitude rho and
/// velocity v, plus an atom for the mass at rest.
/// @pre spring_presses_on_single_wall(problem)
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

}  // namespace contact

}  // namespace fpkcheck::epc
