#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

/// Guaranteed bounds of stationary expectations of a problem (docs/bounds.md), and the solutions
/// that violate them.
namespace fpkcheck::compare {

/// lower <= E[...] <= upper.
struct Bound {
  std::string functional;  ///< "E[y^2]" as in transform::kMoments, or another name: "w1"
  double lower, upper;

  double half_width() const { return (upper - lower) / 2; }
  bool operator==(const Bound&) const = default;
};

struct Bounds {
  /// Why the bounds are missing or wider than requested; else empty.
  std::string reason = {};
  double seconds = 0;  ///< wall-clock time
  std::vector<Bound> each = {};
};

/// The bound of a moment, or null.
const Bound* bound_of(const Bounds& bounds, double transform::Moments::*moment);

/// A moment of a solution that violates its guaranteed bound.
struct BoundViolation {
  const transform::Solution* solution;
  const Bound* bound;
  double value;           ///< the moment
  double excess;          ///< distance from the nearer end of the bound, > 0
  double error_estimate;  ///< error estimate; of a simulation kContradictionStandardErrors of them

  /// True if the violation exceeds the error estimate: then status ok is wrong.
  bool is_contradiction() const { return excess > error_estimate; }
};

/// Number of standard errors beyond which a difference is not attributed to sampling.
inline constexpr double kContradictionStandardErrors = 4;

/// The violated bounds of every solution with a density, in the order of the solutions.
std::vector<BoundViolation> bound_violations(const Bounds& bounds,
                                             std::span<const transform::Solution> solutions);

/// The contradictions of solutions of the full problem (compare/reference.hpp): such a solution is
/// wrong whatever its status.
std::vector<BoundViolation> contradictions(const Bounds& bounds,
                                           std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
