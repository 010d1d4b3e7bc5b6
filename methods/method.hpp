#pragma once

#include <functional>
#include <string>

#include "base/options/value.hpp"
#include "compare/axes.hpp"
#include "methods/residual_error_estimator.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::methods {

/// Receives the completed fraction of a method's work, 0 .. 1, and a note on its state (may be
/// empty).
using ProgressCallback = std::function<void(double, const std::string& note)>;

/// The input of a method besides the problem.
struct SolveContext {
  const compare::ComparisonAxes& axes;  ///< bins of a simulation's histogram
  const ProgressCallback& progress;     ///< may be empty
  /// Residual-based error estimator of the problem, for methods without an error estimate of their
  /// own (set_residual_error_estimate). Null where the caller shares none.
  const ResidualErrorEstimator* error_estimator = nullptr;
  /// False where the caller obtains the error in another way, as by the distance to the reference.
  bool estimate_error = true;
};

/// A solver with fixed options.
struct Method {
  transform::Identity identity;  ///< of its solutions
  base::Values options = {};     ///< as stored in files
  /// True when the method uses all processors: no other method should run at the same time.
  bool uses_all_processors = false;
  /// Solves a problem. The caller sets the solution's identity and options (solve_with).
  std::function<transform::Solution(const problem::Problem&, const SolveContext&)> solve;
  /// Checks that the options suit a problem, before any method starts on any problem. May be empty.
  /// @throws InputError when the options and the problem are incompatible
  std::function<void(const problem::Problem&)> check = {};

  const std::string& id() const { return identity.id; }
};

}  // namespace fpkcheck::methods
