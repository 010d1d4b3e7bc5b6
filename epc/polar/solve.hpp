#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// The closure in amplitude and phase: p(y, v) = C exp(Q_n(rho, theta)) on y >= 0, Q_n a polynomial
/// of degree n in the coordinates of polar::Coordinates, such that the means of all products
/// rho^p theta^q, 1 <= p + q <= n, are stationary under the exact impact process. It has as many
/// unknowns as the formulation moment, and carries what that cannot: the jump of the density at the
/// origin of the wall, which fans out into the plane, and what rare impulses leave there.
namespace fpkcheck::epc::polar {

/// Solves the equations and judges the root. The status is
///  - ok: the equations are met by a density that has decayed to 1e-4 of its peak where its
///    confinement begins;
///  - inadmissible: a root, but no such density. Density and coefficients are still returned;
///  - not_converged: no root, or one that the quadrature does not resolve.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::polar
