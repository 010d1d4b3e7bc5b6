#pragma once

#include <functional>
#include <string>

#include "base/options/value.hpp"
#include "compare/axes.hpp"
#include "methods/problem_residuals.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Told the fraction of a method's work that is done, 0 .. 1, and what else there is to say of it
/// (may be empty).
using Fraction = std::function<void(double, const std::string& note)>;

/// What a method is given besides the problem.
struct Setting {
  const compare::ComparisonAxes& axes;  ///< a simulation makes its histogram on these
  const Fraction& progress;             ///< may be empty
  /// Of the problem, by which a method that cannot tell its own error has it measured
  /// (state_measured_error). Null where nobody keeps them.
  const ProblemResiduals* residuals = nullptr;
  /// Whether it has its error measured; not where the caller knows a better measure.
  bool measure_error = true;
};

/// One way to solve a problem, ready to run.
struct Method {
  transform::Identity identity;  ///< of the solution it yields
  base::Values options = {};     ///< as files keep them
  /// True when it uses all processors itself, so that nothing else should run beside it.
  bool parallel = false;
  /// The solution's identity and options are filled in by whoever calls it (solve_by).
  std::function<transform::Solution(const problem::Problem&, const Setting&)> solve;
  /// Whether the method can be asked to solve a problem at all, told before any method has begun on
  /// any problem. May be empty: then it can.
  /// @throws InputError when options and problem do not go together
  std::function<void(const problem::Problem&)> check = {};

  const std::string& id() const { return identity.id; }
};

}  // namespace fpkcheck::methods
