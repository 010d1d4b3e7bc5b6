#pragma once

#include <optional>
#include <vector>

#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::mcs {

/// Estimates the first passage above a barrier, or out of the interval between two barriers of the
/// displacement. For a stationary start, one long simulation measures the lengths l of the stays
/// below the barrier, at the upcrossing rate nu:
///
///     E tau = E[l^2] / (2 E[l]),   P(tau > t) = E[(l - t)^+] / E[l],   E[l] = P(below) / nu,
///
/// and the hazard is P(l > t) / E[(l - t)^+] at a time t after the slowest mode has decayed. A
/// second simulation returns each stream to the state `start` after each passage. The standard
/// errors are computed from the differences between streams (jackknife).
///
/// If one simulation contains too few passages, multilevel splitting (simulate_rare_passages())
/// replaces the simulation. Splitting measures min(l, t) at a time t after the slowest mode has
/// decayed, and the hazard g continues the survival probability after the time t:
///
///     E[(l - t)^+] = E[l] - E[min(l, t)],     P(tau > s) = P(tau > t) exp(-g (s - t)), s > t.
///
/// The passage of an energy barrier is detected at impulses and noise kicks. Noise kicks at the
/// interval h miss passages between the kicks. Therefore the barrier is lower by 0.5826 times the
/// standard deviation of the energy change by a kick, which reduces the error from order sqrt(h) to
/// higher order (Gobet, Menozzi, Stochastic Processes and their Applications 120 (2010) 130). At
/// low levels the interval is shorter than in other simulations. The result for an energy barrier
/// has no rate of upcrossings. Under noise a second simulation with twice the interval estimates
/// the error by the interval, which is added to the standard errors.
/// @param barrier barrier in physical coordinates
/// @param times times of the survival probabilities; if empty, ten times up to three mean times
/// @param start start of FirstPassageResult::mean_from_point; empty for a start at rest
/// @throws InputError as make_simulation_plan()
transform::FirstPassageResult estimate_passage(
    const problem::Problem& problem, const SimulationOptions& options,
    const transform::PassageBarrier& barrier, const std::vector<double>& times,
    std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::mcs
