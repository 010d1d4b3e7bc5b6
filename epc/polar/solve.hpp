#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Closure in amplitude and phase: p(y, v) = C exp(Q_n(rho, theta)) on y >= 0, Q_n a polynomial of
/// degree n in polar::Coordinates. The means of all products rho^p theta^q, 1 <= p + q <= n, are
/// stationary under the exact impact process. The number of unknowns is the same as in the
/// formulation moment. Unlike the formulation moment, this closure represents the jump of the
/// density at the origin, and the features that rare impulses cause near the origin.
namespace fpkcheck::epc::polar {

/// Solves the equations of the formulation polar and assesses the root. The status is
///  - ok if the density satisfies the equations and has decayed to 1e-4 of its peak at the
///    confinement level (kLevelDensityLimit);
///  - inadmissible if the density of the root has not decayed in this way. The result still
///    contains the density and the coefficients;
///  - not_converged if no root was found, or if the quadrature does not resolve the root.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::polar
