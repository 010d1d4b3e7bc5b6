#pragma once

#include <functional>
#include <string>

#include "base/options/value.hpp"
#include "compare/comparison_axes.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Function that receives the completed fraction, 0 .. 1, of the work of a method, and a note on
/// the state of the method. The note may be empty.
using ProgressCallback = std::function<void(double, const std::string& note)>;

/// The input of a method in addition to the problem.
struct SolveContext {
  const compare::ComparisonAxes& axes;  ///< comparison bins, which a simulation's histogram uses
  const ProgressCallback& progress;     ///< receives the progress of the method; may be empty
  /// Residual-based error estimator of the problem, for methods that do not estimate their errors
  /// otherwise (set_residual_error_estimate). Null if the caller has no estimator to share.
  const ResidualErrorEstimator* error_estimator = nullptr;
  /// Whether the method must estimate the error of its solution. False if the caller estimates the
  /// error, as by the distance from the reference.
  bool estimate_error = true;
};

/// A solver together with values of its options.
struct Method {
  transform::SolutionIdentity identity;  ///< identity of the solutions of this method
  base::Values options = {};             ///< values of the options, as stored in files
  /// Whether the method uses all processors. No other method should run at the same time.
  bool uses_all_processors = false;
  /// Solves a problem. The caller sets the identity and options of the solution (solve_with).
  std::function<transform::Solution(const problem::Problem&, const SolveContext&)> solve;
  /// Tests whether the options and a problem are compatible. All tests run before the first problem
  /// is solved. May be empty.
  /// @throws InputError when the options and the problem are incompatible
  std::function<void(const problem::Problem&)> check = {};

  const std::string& id() const { return identity.id; }
};

}  // namespace fpkcheck::methods
