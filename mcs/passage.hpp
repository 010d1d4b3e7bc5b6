#pragma once

#include <optional>
#include <vector>

#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::mcs {

/// Estimates the first passage of y above a barrier b. For a stationary start, one long simulation
/// measures the lengths l of the stays of y below the barrier, at the upcrossing rate nu:
///
///     E tau = E[l^2] / (2 E[l]),   P(tau > t) = E[(l - t)^+] / E[l],   E[l] = P(y < b) / nu,
///
/// and the hazard is P(l > t) / E[(l - t)^+] at a time t after the slowest mode has decayed. A
/// second simulation returns each stream to the state `start` after each passage. The standard
/// errors are computed from the differences between streams.
/// @param barrier barrier b in physical coordinates
/// @param times times of the survival probabilities
/// @param start start of Passage::mean_from_point; empty for a start at rest
/// @throws InputError as make_simulation_plan()
transform::Passage estimate_passage(const problem::Problem& problem, const Options& options,
                                    double barrier, const std::vector<double>& times,
                                    std::optional<transform::StartState> start = {});

}  // namespace fpkcheck::mcs
