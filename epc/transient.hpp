#pragma once

#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/transient.hpp"

namespace fpkcheck::epc {

/// Computes the density over time with the order n and the order n-2. The differences between the
/// orders estimate the errors. See half_plane::solve_evolution() for the formulations `moment` and
/// `polar`, and gaussian::solve_evolution().
///
/// The status is `not_offered` for problems that solve_closure() does not support, and for an
/// initial density much narrower than the stationary density or than an impulse. The formulation
/// `gaussian` also refuses the equation kf, an excitation that changes in time, and at a wall an
/// initial density with a mean. The exact density is then the sum of a spike and a broad density,
/// and no exponential polynomial approximates this sum.
/// @param problem problem in any coordinates
/// @throws InputError for invalid options, or an initial mean behind a wall
transform::TransientDensities solve_transient(const problem::Problem& problem,
                                              const ClosureOptions& options,
                                              const transform::TransientRequest& request);

}  // namespace fpkcheck::epc
