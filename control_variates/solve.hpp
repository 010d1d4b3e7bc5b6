#pragma once

#include <optional>

#include "control_variates/prepared.hpp"
#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Simulation without noise: E[f] = E[f + L h] for any function h of the phase plane, and where h
/// nearly solves the backward equation L h = U - f, what is averaged is nearly constant. The
/// simulation gives the average, unbiased whatever h is; the splines of `dual` give h.
namespace fpkcheck::control_variates {

struct Options {
  /// Its `deposit` is chosen here, and a `step` of 0.5 if it has none. Its `progress` is told of a
  /// fraction above 0 only when the control functions are there: before, there is nothing that the
  /// simulation could soon end with.
  mcs::Options simulation{};
  /// Automatic: 80 x 176, and 40 x 88 where so few samples are asked for that the fit would take
  /// many times as long as the simulation.
  std::optional<Cells> cells{};
};

/// Simulates, fits the control functions meanwhile, and gives what both tell: moments with what is
/// left of their errors, and both marginals in smooth bins; the plain estimates stay as
/// observations, with the checks. Where motion, impacts or wall are not those of the problem the
/// status is failed; checks that chance enters are notes. With white noise or tails, which
/// have no control functions, and where the fit breaks down, it is the plain simulation, with a note.
/// @throws InputError as mcs::solve
transform::Solution solve(const problem::Problem& problem, const Options& options = {});

}  // namespace fpkcheck::control_variates
