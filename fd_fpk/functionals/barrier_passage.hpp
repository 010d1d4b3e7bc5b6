#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/functionals/passage_values.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"

namespace fpkcheck::fd_fpk {

/// Data of a first passage of the displacement, in wall coordinates.
struct DisplacementPassageProblem {
  const problem::Problem& problem;
  const FiniteVolumeOptions& options;
  const problem::MotionScales& scales;
  double barrier;
  std::optional<double> lower_barrier;
  std::optional<transform::PassageStartState> start;
  /// Rate of the impulses that end the rest of an initial state at rest; 0 if noise ends the rest,
  /// or if the initial state moves
  double waiting_rate;
  PhasePlaneBox box;  ///< box of the stationary density, whose right end is beyond the barrier
};

/// Returns why BarrierGrid does not treat a problem; empty if BarrierGrid treats the problem.
std::string barrier_grid_unsupported_reason(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options);

/// Computes the values of a passage by finite differences of the backward equation (BarrierGrid).
/// The stationary density comes from finite volumes.
PassageResultOnGrid barrier_passage_on_grid(const DisplacementPassageProblem& passage,
                                            double refinement, const std::vector<double>& times,
                                            const base::Deadline& deadline);

}  // namespace fpkcheck::fd_fpk
