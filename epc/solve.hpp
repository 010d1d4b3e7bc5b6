#pragma once

#include <string>

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Solves the closure equations of the formulation in `options` and assesses their root. The limits
/// for an accepted root are in epc/summary.hpp. The status `ok` requires that the density decays on
/// the edge of its support, has mass 1, and is near the density of closure order n-2. In the
/// formulation `gaussian` the closure density must also satisfy the balance of power. The status
/// `inadmissible` denotes a root that violates a condition of the status `ok`. A result with the
/// status `inadmissible` still contains the density and the coefficients. The status
/// `not_converged` denotes that no root was found, or that the root depends on the quadrature or on
/// the disc of gaussian::JumpIntegralRemainder. A result with the status `not_converged` has no
/// density.
/// @throws InputError for invalid options
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

/// Returns the reason why the closure does not support a problem, as one phrase, or an empty
/// string.
std::string unsupported_reason(const problem::Problem& problem, const ClosureOptions& options);

}  // namespace fpkcheck::epc
