#pragma once

#include <optional>
#include <vector>

#include "compare/comparison.hpp"
#include "methods/method.hpp"
#include "methods/residual_error_estimator.hpp"

namespace fpkcheck::methods {

/// The largest L1 error with which a closure has the status `ok`. Empty if the options of the
/// closure set no such limit, and for methods other than closures.
std::optional<double> required_accuracy(const Method& method);

/// Completes the error estimates of all solutions of one problem. Afterwards every solution with
/// the status `ok` has an error estimate. The triangle inequality gives an error estimate from the
/// reference: the L1 distance of a solution from the reference plus the error estimate of the
/// reference.
/// - A closure with a required accuracy lacks an error estimate if the residual method was
///   unsupported, not requested, or gave no result. The closure then gets the error estimate from
///   the reference. If only the missing estimate made the closure `inaccurate`, the status is set
///   back to `ok`. If the new estimate exceeds the required accuracy, the status becomes
///   `inaccurate`. Without a reference, an `ok` closure gets its residual-based error estimate.
/// - Any other `ok` solution without an error estimate (an external density, a closure without a
///   required accuracy) gets the error estimate from the reference. Without a reference, a closure
///   gets its residual-based error estimate, and any other solution becomes `inaccurate`.
/// @param methods methods that computed the solutions, in the same order
/// @param comparison the comparison of the solutions, if already computed; else null
void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonAxes& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<transform::Solution>& solutions,
                              const compare::Comparison* comparison = nullptr);

}  // namespace fpkcheck::methods
