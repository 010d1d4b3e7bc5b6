#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "methods/method.hpp"
#include "problem/problem.hpp"
#include "workflows/sweep/plan/points.hpp"

namespace fpkcheck::sweep {

/// The source of the error estimates of closures in a sweep.
enum class ClosureErrorSource {
  reference,  ///< distance to the point's reference, plus the error estimate of the reference
  residuals   ///< residuals in the backward equation, as for a run; needs no other solution
};
inline constexpr base::EnumEntry<ClosureErrorSource> kClosureErrorSourceNames[] = {
    {ClosureErrorSource::reference, "reference"}, {ClosureErrorSource::residuals, "residuals"}};
constexpr std::span<const base::EnumEntry<ClosureErrorSource>> enumerator_names(
    ClosureErrorSource) {
  return kClosureErrorSourceNames;
}
constexpr std::string_view name(ClosureErrorSource errors) { return base::name_of(errors); }

/// The plan of a sweep: a base case, the varied keys with their values, and the methods that solve
/// each point.
struct Plan {
  problem::Problem base;
  std::vector<Axis> axes;
  PlanDesign design = PlanDesign::product;
  std::size_t sobol_points = 0;            ///< 0 for other designs
  std::vector<methods::Method> methods{};  ///< by increasing trust
  bool marginals = false;                  ///< whether the marginal densities are stored
  ClosureErrorSource closure_errors = ClosureErrorSource::reference;
  Points points{};  ///< make_points() of the axes

  /// The problem at a point: the base case with the values of the point.
  /// @throws InputError if the values are inconsistent
  problem::Problem problem_at(std::size_t point) const;
};

}  // namespace fpkcheck::sweep
