#pragma once

#include <vector>

#include "results/run.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// A solved point of a sweep.
struct SolvedPoint {
  PointResult result;
  std::vector<results::Curve> curves;  ///< marginal densities, if the plan stores them
};

/// Solves a point by all methods of its plan, one after another, and compares them with the point's
/// reference. A failure (inconsistent values, insufficient memory) is a result with status `failed`
/// and a reason.
SolvedPoint solve_point(const Plan& plan, std::size_t point);

}  // namespace fpkcheck::sweep
