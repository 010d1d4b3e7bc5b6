#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Solves the equations of the formulation and judges the root. The status is
///  - ok: a root, and its density has decayed on the whole edge of its support, has the mass 1, and
///    is near that of order n-2 (form/allowed.hpp has the bounds; gaussian: and keeps the balance
///    of power);
///  - inadmissible: a root, but not such a density. Density and coefficients are still returned;
///  - not_converged: no root was found, or none that stands on a plateau of the disc of
///    gaussian::JumpRemainder (gaussian with kf) or that the quadrature resolves (moment, polar);
///    no density.
/// @throws InputError from validate
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc
