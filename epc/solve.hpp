#pragma once

#include <string>

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Solves the equations of the formulation and assesses the root. The status is
///  - ok if the density of the root has decayed on the whole edge of its support, has mass 1, and
///    is near the density of order n-2. The limits are in summary.hpp. In the
///    formulation gaussian, the density must also satisfy the balance of power;
///  - inadmissible if a root was found, but its density violates one of these conditions. The
///    result still contains the density and the coefficients;
///  - not_converged if no root was found. The solver also discards a root that depends on the disc
///    of gaussian::JumpIntegralRemainder (gaussian with kf), and a root that the quadrature does
///    not resolve (moment, polar). The result has no density.
/// @throws InputError from validate
Result solve(const problem::Problem& problem, const Options& options);

/// Reason why the closure does not support a problem, as one phrase. The reason is empty if the
/// closure supports the problem.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc
