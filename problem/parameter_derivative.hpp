#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// A problem with a changed parameter, and the weight of the problem in a difference quotient.
struct DifferenceQuotientTerm {
  double weight;
  Problem problem;
};

/// Difference quotient of second order for the derivative with respect to one parameter theta of a
/// problem. For a function F of the problem, dF/dtheta is approximately the sum of weight times
/// F(problem) over all terms of the difference quotient.
struct ParameterDifferenceQuotient {
  std::string parameter;  ///< key of the case file, such as "system.damping"
  double value;           ///< value of the parameter
  std::vector<DifferenceQuotientTerm> terms;
};

/// Returns the keys of all numeric parameters with a value other than the default value, except the
/// positions of walls: a change of a wall position would move the domain of the density.
std::vector<std::string> differentiable_parameters(const Problem& problem);

/// Returns a central difference quotient with two terms, or, at an end of the range of the
/// parameter such as the restitution coefficient 1, a one-sided difference quotient with three
/// terms.
/// @param problem problem in physical coordinates
/// @param relative_step largest step divided by the value of the parameter; for the value 0 the
/// largest absolute step
/// @throws InputError if the problem has no such parameter, or if no step leaves the problem valid
ParameterDifferenceQuotient parameter_difference_quotient(const Problem& problem,
                                                          const std::string& parameter,
                                                          double relative_step);

}  // namespace fpkcheck::problem
