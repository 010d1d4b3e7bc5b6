#pragma once

#include <string>

#include "epc/options.hpp"
#include "epc/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Solves the closure equations of the formulation in `options` and decides whether the root is
/// accepted. The file epc/summary.hpp defines the limits for an accepted root. The status `ok` of a
/// closure requires that the density decays on the edge of its support, has mass 1, and is near the
/// density of closure order n-2. In the formulation `gaussian` the closure density must also
/// satisfy the balance of power. The status `inadmissible` of a closure denotes a root of the
/// closure equations that violates a condition of the status `ok`. A closure result with the status
/// `inadmissible` still contains the density and the coefficients of Q_n. The status
/// `not_converged` of a closure denotes that no root was found, or that the root changes with the
/// number of quadrature points or with the disc of gaussian::JumpIntegralRemainder. A closure
/// result with the status `not_converged` has no density.
/// @throws InputError for invalid options
ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options);

/// Returns the reason why the closure does not support a problem, as one phrase, or an empty string
/// for a supported problem.
std::string unsupported_reason(const problem::Problem& problem, const ClosureOptions& options);

}  // namespace fpkcheck::epc
