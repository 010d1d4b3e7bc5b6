#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Solves the equations of the formulation and assesses the root. The status is
///  - ok: a root whose density has decayed on the whole edge of its support, has mass 1, and is
///    near the density of order n-2. Limits: form/acceptance_limits.hpp. The formulation gaussian
///    also requires the balance of power;
///  - inadmissible: a root without such a density. Density and coefficients are still returned;
///  - not_converged: no root was found, and there is no density. Also a root that depends on the
///    disc of gaussian::JumpRemainder (gaussian with kf), or that the quadrature does not resolve
///    (moment, polar).
/// @throws InputError from validate
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc
