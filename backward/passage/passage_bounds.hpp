#pragma once

#include <optional>

#include "backward/passage/mean_time_certificate.hpp"
#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::backward {

/// Options of the guaranteed bounds of mean passage times, the method `bounds`.
struct PassageBoundsOptions {
  double accuracy = 1e-2;   ///< largest relative half-width for the status `ok`
  double max_seconds = 10;  ///< time limit in seconds (wall clock)
};

/// Returns the oscillator of a problem in wall coordinates.
/// @pre the problem has the oscillator of the paper
ImpactOscillator impact_oscillator(const problem::Problem& problem, double barrier);

/// Computes guaranteed lower and upper bounds of the mean time of the first passage of y above a
/// barrier, from rest on the wall (docs/functionals.md). FirstPassageResult::mean_from_point has
/// the middle of the bounds, and half of their distance as its error. The status is `not_offered`
/// unless the problem has the oscillator of the paper, Gaussian impulses with mean 0 and the start
/// at rest.
transform::FirstPassageResult bound_passage(const problem::Problem& problem,
                                            const PassageBoundsOptions& options, double barrier,
                                            std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::backward
