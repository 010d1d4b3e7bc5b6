#pragma once

#include <string>
#include <vector>

#include "methods/method.hpp"
#include "problem/problem.hpp"
#include "sweep/plan/points.hpp"

namespace fpkcheck::sweep {

/// What a sweep solves: a case whose keys are varied, and the methods for each point.
struct Plan {
  problem::Problem base;
  std::vector<Axis> axes;
  Design design = Design::product;
  std::size_t sobol_points = 0;            ///< 0 for other designs
  std::vector<methods::Method> methods{};  ///< by increasing trust
  bool marginals = false;                  ///< whether those of every point are kept
  Points points{};                         ///< points_of() the axes

  /// The case with the values of a point.
  /// @throws InputError where they do not fit together
  problem::Problem problem_at(std::size_t point) const;
};

}  // namespace fpkcheck::sweep
