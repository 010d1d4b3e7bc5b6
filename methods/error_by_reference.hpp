#pragma once

#include <optional>
#include <vector>

#include "compare/comparison.hpp"
#include "methods/method.hpp"
#include "methods/problem_residuals.hpp"

namespace fpkcheck::methods {

/// The accuracy that a closure is held to; nothing where it is not, or is no closure.
std::optional<double> accuracy_of(const Method& method);

/// Completes what the solutions of one problem state of their errors, when all of them are there; none
/// stays `ok` without a stated error.
/// - Closures without an error, whose residuals are not offered, were not asked for or gave none, have
///   their distance to the reference among the solutions and what it states of itself together (the
///   triangle inequality). Those that were `inaccurate` only for want of an error are ok first; off by
///   more than their accuracy, or without a reference, they are `inaccurate`.
/// - So have all others that are ok and state none (a density of one's own, closures that are held to no
///   accuracy); without a reference closures have what their residuals measure, and others are
///   `inaccurate`.
/// @param methods that the solutions are of, in their order
/// @param known the comparison of the solutions, if there is one already
void complete_errors(const std::vector<Method>& methods, const compare::ComparisonAxes& axes,
                     const ProblemResiduals& residuals, std::vector<transform::Solution>& solutions,
                     const compare::Comparison* known = nullptr);

}  // namespace fpkcheck::methods
