#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

/// Guaranteed bounds of stationary expectations of a problem (docs/bounds.md), and solutions that
/// violate these bounds.
namespace fpkcheck::compare {

/// Guaranteed bounds lower <= E[g] <= upper of the stationary expectation of one functional g.
struct GuaranteedBound {
  /// Name of the functional: a symbol of transform::kMoments such as "E[y^2]", or another name such
  /// as "w1" (momentum flux of impacts).
  std::string functional;
  double lower, upper;

  double half_width() const { return (upper - lower) / 2; }
  bool operator==(const GuaranteedBound&) const = default;
};

struct GuaranteedBounds {
  /// Reason why guaranteed bounds are missing or wider than requested; empty if as requested.
  std::string reason = {};
  double seconds = 0;
  std::vector<GuaranteedBound> each = {};
};

const GuaranteedBound* find_moment_bound(const GuaranteedBounds& bounds,
                                         double transform::Moments::*moment);

/// A moment of a solution outside the guaranteed bounds of this moment.
struct BoundViolation {
  const transform::Solution* solution;
  const GuaranteedBound* bound;
  double value;
  double excess;  ///< distance > 0 of the moment from the violated bound
  /// Error estimate of the moment. For a simulation the error estimate is at least
  /// kContradictionStandardErrors times the standard error of the moment.
  double error_estimate;

  /// A solution of the full problem whose moment violates a guaranteed bound by more than the error
  /// estimate is wrong, even with the status `ok`.
  bool exceeds_error_estimate() const { return excess > error_estimate; }
};

/// Largest deviation of a simulated moment, in standard errors, attributed to sampling errors.
inline constexpr double kContradictionStandardErrors = 4;

/// Returns all moments outside their guaranteed bounds, for every solution with a density.
std::vector<BoundViolation> bound_violations(const GuaranteedBounds& bounds,
                                             std::span<const transform::Solution> solutions);

/// Returns the violations of guaranteed bounds by solutions of the full problem that exceed the
/// error estimates of the solutions. A violation of a bound beyond the error estimate proves that a
/// solution of the full problem is wrong, since guaranteed bounds hold for the full problem.
std::vector<BoundViolation> violations_beyond_error_estimate(
    const GuaranteedBounds& bounds, std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
