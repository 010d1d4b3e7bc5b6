#pragma once

#include <filesystem>
#include <vector>

#include "results/run.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

struct SolvedSweepPoint {
  SweepPointResult result;
  /// Marginal densities at the sweep point; empty unless the sweep plan requests their storage.
  std::vector<results::DensityCurve> curves;
};

/// Solves a sweep point by all methods of the plan, and compares the solutions with the reference
/// solution of the point. After a failure (inconsistent values, insufficient memory) the result of
/// a sweep point has the status `failed` and a reason.
SolvedSweepPoint solve_sweep_point(const SweepPlan& plan, std::size_t point);

/// Writes the marginal densities of a sweep point, if the result has any, to marginals/NUMBER.csv.
/// @throws std::runtime_error with a message of one line
void write_marginals(const SweepPlan& plan, const std::filesystem::path& directory,
                     const SolvedSweepPoint& solved);

}  // namespace fpkcheck::sweep
