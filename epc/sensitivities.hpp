#pragma once

#include <vector>

#include "epc/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::epc {

/// Computes the derivatives of the moments of a stationary closure with respect to parameters of
/// the problem, by difference quotients of closures of problems with changed parameters. The error
/// estimates of the derivatives are the differences from the derivatives of the closure of order
/// n-2; for n = 2 the error estimates are NaN.
///
/// The status is `not_converged` if the closure of a problem with changed parameters does not have
/// the status `ok`. The status of the sensitivities does not depend on ClosureOptions::accuracy.
/// @param parameters difference quotients with relative parameter steps of about 1e-3; the closures
///   have relative errors of about 1e-10
/// @throws InputError for invalid options
transform::MomentSensitivities solve_sensitivities(
    const problem::Problem& problem, const ClosureOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters);

}  // namespace fpkcheck::epc
