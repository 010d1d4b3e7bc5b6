#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/names.hpp"
#include "methods/method.hpp"
#include "problem/problem.hpp"
#include "workflows/sweep/plan/points.hpp"

namespace fpkcheck::sweep {

/// How a closure, which does not know its own error, comes to one.
enum class ClosureErrors {
  reference,  ///< the distance to the point's reference and what that states of itself, added
  residuals   ///< as in a run: by the backward equation, without another solution
};
inline constexpr base::Named<ClosureErrors> kClosureErrorsNames[] = {
    {ClosureErrors::reference, "reference"}, {ClosureErrors::residuals, "residuals"}};
constexpr std::span<const base::Named<ClosureErrors>> names(ClosureErrors) {
  return kClosureErrorsNames;
}
constexpr std::string_view name(ClosureErrors errors) { return base::name_of(errors); }

/// What a sweep solves: a case whose keys are varied, and the methods for each point.
struct Plan {
  problem::Problem base;
  std::vector<Axis> axes;
  Design design = Design::product;
  std::size_t sobol_points = 0;            ///< 0 for other designs
  std::vector<methods::Method> methods{};  ///< by increasing trust
  bool marginals = false;                  ///< whether those of every point are kept
  ClosureErrors closure_errors = ClosureErrors::reference;
  Points points{};  ///< points_of() the axes

  /// The case with the values of a point.
  /// @throws InputError where they do not fit together
  problem::Problem problem_at(std::size_t point) const;
};

}  // namespace fpkcheck::sweep
