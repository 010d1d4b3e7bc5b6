#pragma once

#include <optional>

#include "control_variates/control_variate_setup.hpp"
#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Simulation with control variates. For every function h on the phase plane, E[f] = E[f + L h]
/// with the generator L of the oscillator. The control function h approximately solves the equation
/// L h = U - f with a constant U. The function f + L h is then nearly constant, and the mean of f +
/// L h has a small sampling error. The library `backward` fits h on splines.
namespace fpkcheck::control_variates {

struct ControlVariateOptions {
  /// Options of the simulation. The function simulate_with_control_variates() sets `deposit`, and
  /// sets an empty `step` to 0.5 rad. The reported progress of the simulation is 0 until the fit of
  /// the control variates ends.
  mcs::SimulationOptions simulation{};
  /// Numbers of spline cells in y and in v for the fit of the control variates. The default is 64 x
  /// 100 spline cells; without checkpoints 40 x 88 if the time limit of the simulation is below 2e5
  /// sampling intervals, and 80 x 176 above 1e7.
  std::optional<ControlVariateSplineCellCounts> cells{};
};

/// Simulates the oscillator and fits the control variates, at the same time if there are several
/// threads. Returns moments, and marginal densities averaged over smooth bins, with sampling errors
/// reduced by control variates. If a check of the simulation without sampling error fails, the
/// status is `failed`. Any other failed check adds a note.
///
/// The result is a simulation without control variates, with a note, for equations other than `kf`,
/// with the option `tails`, for unsupported oscillators, if memory is insufficient, and if the fit
/// fails.
/// @throws InputError for options that mcs::solve refuses
transform::Solution simulate_with_control_variates(const problem::Problem& problem,
                                                   const ControlVariateOptions& options = {});

}  // namespace fpkcheck::control_variates
