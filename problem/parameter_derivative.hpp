#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// A problem with a changed parameter, and its weight in a difference quotient.
struct WeightedProblem {
  double weight;
  Problem problem;
};

/// Difference quotient of second order for the derivative with respect to one parameter: for a
/// function F of the problem, dF/dtheta ~ sum of weight F(problem).
struct ParameterDerivative {
  std::string parameter;  ///< key of the case file, such as "system.damping"
  double value;           ///< value of the parameter
  std::vector<WeightedProblem> terms;
};

/// Returns the keys of all parameters with a number that differs from the default value, without the
/// positions of walls, whose change would move the domain of the density.
std::vector<std::string> differentiable_parameters(const Problem& problem);

/// Returns a central difference quotient, or a one-sided one with three terms at an end of the range
/// of the parameter, such as the restitution 1.
/// @param problem problem in physical coordinates
/// @param relative_step largest step relative to the value of the parameter; the absolute step for the
/// value 0
/// @throws InputError if the problem has no such parameter, or if no step leaves the problem valid
ParameterDerivative parameter_derivative(const Problem& problem, const std::string& parameter,
                                         double relative_step);

}  // namespace fpkcheck::problem
