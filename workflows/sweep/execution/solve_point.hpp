#pragma once

#include <filesystem>
#include <vector>

#include "results/run.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

struct SolvedSweepPoint {
  SweepPointResult result;
  /// Marginal densities of the point; empty unless the plan requests their storage.
  std::vector<results::DensityCurve> curves;
};

/// Solves a point by all methods of the plan, and compares the solutions with the point's
/// reference. After a failure (inconsistent values, insufficient memory) the result has the status
/// `failed` and a reason.
SolvedSweepPoint solve_sweep_point(const SweepPlan& plan, std::size_t point);

/// Writes the marginal densities of a point, if any, to marginals/NUMBER.csv.
/// @throws std::runtime_error with a message of one line
void write_marginals(const SweepPlan& plan, const std::filesystem::path& directory,
                     const SolvedSweepPoint& solved);

}  // namespace fpkcheck::sweep
