#pragma once

#include <vector>

#include "epc/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::epc {

/// Computes the derivatives of the moments of a stationary closure with respect to parameters, by
/// difference quotients of the roots of changed problems. The differences to the derivatives of the
/// closure of order n-2 estimate the errors; they are NaN for n = 2.
///
/// The status is `not_converged` if a root of a changed problem does not have the status `ok`. The
/// solution does not compare the errors with Options::accuracy.
/// @param parameters derivatives with steps of about 1e-3: the roots have relative errors of about
///   1e-10, and the quotients relative errors of second order
/// @throws InputError for invalid options
transform::Sensitivities solve_sensitivities(
    const problem::Problem& problem, const Options& options,
    const std::vector<problem::ParameterDerivative>& parameters);

}  // namespace fpkcheck::epc
