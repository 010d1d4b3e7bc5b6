#pragma once

#include <optional>

#include "control_variates/control_setup.hpp"
#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Options of the simulation with control variates. E[f] = E[f + L h] for any function h on the
/// phase plane. If h nearly solves the backward equation L h = U - f, the quantity f + L h is
/// nearly constant and its mean has a small sampling error. The simulation estimates this mean,
/// unbiased for any h; `backward` fits h on splines.
namespace fpkcheck::control_variates {

struct Options {
  /// Options of the simulation. solve() sets `deposit`, and sets an empty `step` to 0.5. `progress`
  /// receives a fraction above 0 only after the fit of the control functions, since the simulation
  /// cannot end before the end of the fit.
  mcs::Options simulation{};
  /// Numbers of cells of the control functions. Default: 80 x 176 cells. If so few samples are
  /// requested that the fit would take many times as long as the simulation, the default is 40 x 88
  /// cells.
  std::optional<ControlCells> cells{};
};

/// Simulates the oscillator, fits the control functions at the same time, and combines both. The
/// results are moments and marginals in smooth bins with reduced sampling errors. The plain
/// estimates and the checks become metrics.
///
/// The status is failed if a check without sampling error fails: the simulated motion, impacts or
/// wall then differ from the problem. A failed check with sampling error gives a note only. With
/// white noise, with `tails` and after a failed fit there are no control functions: the result is
/// then the plain simulation, with a note.
/// @throws InputError as mcs::solve
transform::Solution solve(const problem::Problem& problem, const Options& options = {});

}  // namespace fpkcheck::control_variates
