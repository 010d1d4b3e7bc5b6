#pragma once

#include <vector>

#include "mcs/options.hpp"
#include "problem/parameter_derivative.hpp"
#include "problem/problem.hpp"
#include "transform/sensitivities.hpp"

namespace fpkcheck::mcs {

/// Estimates the derivatives of the stationary moments with respect to parameters, by difference
/// quotients of simulations with common random numbers: the streams of all changed problems draw
/// the same impulses in the same order, so that most of the sampling error cancels in the
/// difference quotients of each trajectory stream. The standard errors are computed from the
/// differences between trajectory streams, without the error of the difference quotients, which is
/// of second order in the parameter step.
/// @param parameters derivatives with steps of about 2 %
/// @throws InputError as make_simulation_plan()
transform::MomentSensitivities estimate_sensitivities(
    const problem::Problem& problem, const SimulationOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters);

}  // namespace fpkcheck::mcs
