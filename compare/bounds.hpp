#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

/// Guaranteed bounds of stationary expectations of a problem (docs/bounds.md), and which solutions
/// they contradict.
namespace fpkcheck::compare {

/// lower <= E[...] <= upper.
struct Bound {
  std::string functional;  ///< "E[y^2]" as transform::kMoments names it, or another: "w1"
  double lower, upper;

  double half_width() const { return (upper - lower) / 2; }
  bool operator==(const Bound&) const = default;
};

struct Bounds {
  /// Why there are none, or why they are wider than asked for; empty otherwise.
  std::string reason = {};
  double seconds = 0;  ///< wall-clock time
  std::vector<Bound> each = {};
};

/// The bounds of a moment, or null.
const Bound* bound_of(const Bounds& bounds, double transform::Moments::*moment);

/// A moment of a solution that is not within its bounds.
struct Outside {
  const transform::Solution* solution;
  const Bound* bound;
  double value;      ///< the moment
  double by;         ///< how far it is from the nearer end, > 0
  double own_error;  ///< what its method states of it; of a simulation kSureErrors standard errors

  /// No method errs by more than it says: then the status `ok` was wrong.
  bool is_contradiction() const { return by > own_error; }
};

/// Standard errors beyond which a difference is not called chance.
inline constexpr double kSureErrors = 4;

/// Of every solution that has a density, the moments outside their bounds, in the order of the
/// solutions.
std::vector<Outside> outside(const Bounds& bounds, std::span<const transform::Solution> solutions);

/// Of these the contradictions by solutions of the problem itself (compare/reference.hpp): they are
/// wrong whatever their status.
std::vector<Outside> contradictions(const Bounds& bounds,
                                    std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
