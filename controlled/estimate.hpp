#pragma once

#include "controlled/checks.hpp"
#include "controlled/combine.hpp"
#include "controlled/prepared.hpp"
#include "mcs/solve.hpp"

/// Simulation without noise: E[f] = E[f + L h] for any function h of the phase plane, and where h
/// nearly solves the backward equation L h = U - f, what is averaged is nearly constant. The
/// simulation gives the average, unbiased whatever h is; the splines of `dual` give h.
namespace fpkcheck::controlled {

struct Options {
  /// Its `deposit` is chosen here, and a `step` of 0.5 if it has none.
  mcs::Options simulation{};
  Cells cells{};
};

struct Result {
  Estimates estimates;
  Checks checks;
  mcs::Result simulation;  ///< with the deposits taken out
  std::vector<double> backward_means;
};

/// Simulates, and fits the control functions meanwhile.
/// @throws InputError as mcs::solve, dual::FitBrokeDown
Result estimate(const problem::Problem& problem, const Options& options = {});

/// Estimates and checks from what a simulation has deposited on prepared.places.grid.
Result combined(const Prepared& prepared, mcs::Result simulation);

}  // namespace fpkcheck::controlled
