#pragma once

#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/transient.hpp"

namespace fpkcheck::epc {

/// Computes the density over time by the closures of order n and of order n-2. The differences
/// between the closures of orders n and n-2 estimate the errors of the density. The functions
/// half_plane::solve_evolution() (formulations `moment` and `polar`) and
/// gaussian::solve_evolution() integrate the closure equations over time.
///
/// The status of a closure over time is `not_offered` for problems that solve_closure() does not
/// support, and for an initial density much narrower than the stationary density or than the size
/// of an impulse. The formulation `gaussian` also refuses the equation `kf`, an excitation that
/// changes in time, and, with a wall, an initial density with a nonzero mean. The exact density
/// soon after such a narrow initial density is the sum of a narrow peak and a broad density, and no
/// exponential polynomial approximates this sum.
/// @param problem problem in any coordinates
/// @throws InputError for invalid options, or an initial mean behind a wall
transform::TransientDensities solve_transient(const problem::Problem& problem,
                                              const ClosureOptions& options,
                                              const transform::TransientRequest& request);

}  // namespace fpkcheck::epc
