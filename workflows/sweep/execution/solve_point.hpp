#pragma once

#include <vector>

#include "results/run.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// What comes of a point.
struct SolvedPoint {
  PointResult result;
  std::vector<results::Curve> curves;  ///< the marginals, where the plan keeps them
};

/// Solves a point by all methods of its plan, one after another, and compares them with the point's
/// reference. What cannot be solved (values that do not fit together, no memory left) is a result
/// too: `failed`, with its reason.
SolvedPoint solve_point(const Plan& plan, std::size_t point);

}  // namespace fpkcheck::sweep
