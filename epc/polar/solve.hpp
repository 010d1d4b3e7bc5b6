#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Closure in amplitude and phase: p(y, v) = C exp(Q_n(rho, theta)) on y >= 0, Q_n a polynomial of
/// degree n in polar::Coordinates. The means of all products rho^p theta^q, 1 <= p + q <= n, are
/// stationary under the exact impact process. The number of unknowns is that of the formulation
/// moment. Unlike moment, the closure represents the jump of the density at the origin and the
/// features that rare impulses cause there.
namespace fpkcheck::epc::polar {

/// Solves the equations and assesses the root. The status is
///  - ok: the density satisfies the equations and has decayed to 1e-4 of its peak at the
///    confinement level (kLevelDensityLimit);
///  - inadmissible: a root without such a density. Density and coefficients are still returned;
///  - not_converged: no root, or a root that the quadrature does not resolve.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::polar
