#pragma once

#include <optional>

#include "methods/method.hpp"
#include "methods/problem_residuals.hpp"

namespace fpkcheck::methods {

/// The accuracy that a closure is held to; nothing where it is not, or is no closure.
std::optional<double> accuracy_of(const Method& method);

/// How far a solution's marginals are from the reference's, in L1.
struct Distance {
  double y, ydot;
};

/// Gives a closure the error that its distance to the reference and what that does not know of
/// itself make together (the triangle inequality). If it is ok, but off by more, it becomes
/// `inaccurate`; if it is `inaccurate` only because its residuals gave no error, it is ok first.
void state_distance(const transform::Solution& reference, const Distance& distance, double accuracy,
                    transform::Solution& solution);

/// Of closures without an error, whose residuals are not offered or gave none: they are held to their
/// accuracy by the reference among the solutions, if there is one, and are `inaccurate` if not.
/// @param methods that they are of, in their order
void state_errors_by_reference(const std::vector<Method>& methods,
                               const compare::ComparisonAxes& axes,
                               const ProblemResiduals& residuals,
                               std::vector<transform::Solution>& solutions);

}  // namespace fpkcheck::methods
