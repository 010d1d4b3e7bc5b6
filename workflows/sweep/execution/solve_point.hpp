#pragma once

#include <filesystem>
#include <vector>

#include "results/run.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A solved point of a sweep: the result that the journal stores, and the marginal densities.
struct SolvedPoint {
  PointResult result;
  std::vector<results::Curve> curves;  ///< marginal densities, if the plan stores them
};

/// Solves a point by all methods of the plan, one method after another, and compares the solutions
/// with the reference of the point. After a failure (inconsistent values, insufficient memory) the
/// result has the status `failed` and a reason.
SolvedPoint solve_point(const Plan& plan, std::size_t point);

/// Writes the marginal densities of a point to marginals/NUMBER.csv. No file is written if the
/// point has no marginal density.
/// @throws std::runtime_error with a message of one line
void write_marginals(const Plan& plan, const std::filesystem::path& directory,
                     const SolvedPoint& solved);

}  // namespace fpkcheck::sweep
