#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

/// Guaranteed bounds of stationary expectations of a problem (docs/bounds.md), and the solutions
/// that violate these bounds.
namespace fpkcheck::compare {

/// Guaranteed bounds of the stationary expectation of one functional: lower <= E[..] <= upper.
struct GuaranteedBound {
  /// Name of the functional: a symbol of transform::kMoments such as "E[y^2]", or another name,
  /// such as "w1".
  std::string functional;
  double lower, upper;

  double half_width() const { return (upper - lower) / 2; }
  bool operator==(const GuaranteedBound&) const = default;
};

/// All guaranteed bounds of one problem.
struct GuaranteedBounds {
  /// Reason for missing bounds, or for bounds that are wider than requested; else empty.
  std::string reason = {};
  double seconds = 0;                      ///< wall-clock time of the computation
  std::vector<GuaranteedBound> each = {};  ///< the bounds, by functional
};

/// The guaranteed bounds of a moment; null if `bounds` lacks the moment.
const GuaranteedBound* find_moment_bound(const GuaranteedBounds& bounds,
                                         double transform::Moments::*moment);

/// A moment of a solution outside the guaranteed bounds of that moment.
struct BoundViolation {
  const transform::Solution* solution;
  const GuaranteedBound* bound;
  double value;   ///< value of the moment in the solution
  double excess;  ///< distance of the value from the nearer bound, > 0
  /// Error estimate of the moment; for a simulation at least kContradictionStandardErrors times the
  /// standard error of the moment.
  double error_estimate;

  /// Whether the violation exceeds the error estimate of the moment. A solution with such a
  /// violation is wrong, even with the status ok.
  bool exceeds_error_estimate() const { return excess > error_estimate; }
};

/// Largest difference, in standard errors, that is attributed to sampling errors.
inline constexpr double kContradictionStandardErrors = 4;

/// All moments outside their guaranteed bounds, of every solution with a density, in the order of
/// the solutions.
std::vector<BoundViolation> bound_violations(const GuaranteedBounds& bounds,
                                             std::span<const transform::Solution> solutions);

/// The bound violations beyond the error estimate, of those solutions that
/// is_solution_of_full_problem() accepts. A solution in this list is wrong: guaranteed bounds hold
/// for the full problem.
std::vector<BoundViolation> bound_contradictions(const GuaranteedBounds& bounds,
                                                 std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
