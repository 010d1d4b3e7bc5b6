#pragma once

#include <optional>

#include "control_variates/control_setup.hpp"
#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Simulation with control variates. E[f] = E[f + L h] for any function h on the phase plane. Where
/// h nearly solves the backward equation L h = U - f, the averaged quantity is nearly constant. The
/// simulation gives the average, unbiased for any h; `backward` fits h on splines.
namespace fpkcheck::control_variates {

struct Options {
  /// Options of the simulation. solve() sets `deposit`, and `step` = 0.5 where it is empty.
  /// `progress` receives a fraction above 0 only after the fit of the control functions, since the
  /// simulation cannot end before.
  mcs::Options simulation{};
  /// Default: 80 x 176 cells, and 40 x 88 where so few samples are requested that the fit would
  /// take many times as long as the simulation.
  std::optional<ControlCells> cells{};
};

/// Simulates, fits the control functions at the same time, and combines both: moments and smooth
/// marginals with reduced sampling errors. The plain estimates and the checks become metrics.
///
/// The status is failed where a check without sampling error fails: motion, impacts or wall differ
/// from the problem. The result of statistical checks is a note. White noise, tails and a failed
/// fit have no control functions: the result is the plain simulation, with a note.
/// @throws InputError as mcs::solve
transform::Solution solve(const problem::Problem& problem, const Options& options = {});

}  // namespace fpkcheck::control_variates
