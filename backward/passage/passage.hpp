#pragma once

#include <optional>

#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::backward {

struct PassageOptions {
  double accuracy = 1e-2;   ///< largest relative error for status ok
  double max_seconds = 10;  ///< time limit
};

/// Computes the hazard and the mean time from a point of the first passage of y above a barrier, by
/// collocation of the renewal equation along the motion between impulses (RenewalEquation). The
/// mean time T to the passage satisfies
///
///     T(y, v) = int_0^te exp(-lambda t) (1 + lambda h(X_t)) dt,   h(y, v) = E T(y, v + Y),
///
/// where te is the time of the passage without a further impulse. T jumps across the motion that
/// grazes the barrier, but h is smooth except at rest on the wall. The hazard is the least number g
/// for which 1 is an eigenvalue of lambda A with the weight exp(-(lambda - g) t). The errors are
/// four times the differences from fewer nodes.
/// @param start start of Passage::mean_from_point; empty for a start at rest
transform::Passage solve_passage(const problem::Problem& problem, const PassageOptions& options,
                                 double barrier, std::optional<transform::StartState> start = {});

}  // namespace fpkcheck::backward
