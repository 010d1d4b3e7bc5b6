#pragma once

#include <optional>
#include <vector>

#include "compare/comparison.hpp"
#include "methods/method.hpp"
#include "methods/residual_error_estimator.hpp"

namespace fpkcheck::methods {

/// The accuracy that a closure must reach to be `ok`. No value where its options set none, and for
/// methods other than closures.
std::optional<double> required_accuracy(const Method& method);

/// Completes the error estimates of all solutions of one problem. No solution stays `ok` without an
/// error estimate.
/// - A closure with a required accuracy and without an error estimate (residual method unsupported,
///   not requested, or without result) gets its L1 distance to the reference plus the reference's
///   own error estimate, by the triangle inequality. If the missing estimate alone made it
///   `inaccurate`, it becomes `ok` first. It is `inaccurate` if the sum exceeds the required
///   accuracy. Without a reference, an `ok` closure gets its residual-based estimate.
/// - Any other `ok` solution without an error estimate (an external density, a closure without a
///   required accuracy) gets the same sum. Without a reference, a closure gets its residual-based
///   estimate, and any other solution becomes `inaccurate`.
/// @param methods of the solutions, in the same order
/// @param comparison the comparison of the solutions, if already computed
void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonAxes& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<transform::Solution>& solutions,
                              const compare::Comparison* comparison = nullptr);

}  // namespace fpkcheck::methods
