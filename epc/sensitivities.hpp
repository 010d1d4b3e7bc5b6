#pragma once

#include <vector>

#include "epc/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::epc {

/// Computes the derivatives of the moments of a stationary closure with respect to parameters, by
/// difference quotients of the roots of changed problems. The error estimates are the differences
/// to the derivatives of the closure of order n-2; for n = 2 the error estimates are NaN.
///
/// The status is `not_converged` if a root of a changed problem does not have the status `ok`. The
/// status does not depend on ClosureOptions::accuracy.
/// @param parameters derivatives with steps of about 1e-3: the roots have relative errors of about
///   1e-10, and the quotients relative errors of second order
/// @throws InputError for invalid options
transform::MomentSensitivities solve_sensitivities(
    const problem::Problem& problem, const ClosureOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters);

}  // namespace fpkcheck::epc
