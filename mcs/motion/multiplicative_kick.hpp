#pragma once

#include "mcs/motion/advance_trajectories.hpp"

namespace fpkcheck::mcs {

/// Advances velocities v at fixed displacements y along the flow dv/ds = g(y, v) of a noise factor
/// g, by the method of Dormand and Prince with a relative error per step below 1e-7.
/// @param count number of points, at most 8
/// @param durations durations s of the flow, positive or negative
/// @param velocity_scale velocity to which the relative error refers
/// @param g_at_start receives the noise factor g at the initial velocities
void advance_along_noise_flow(const problem::NoiseFactor& factor, int count, const double* y,
                              double* v, const double* durations, double velocity_scale,
                              double* g_at_start);

/// Computes the factor g(y, v) of multiplicative noise at `count` <= 8 points. @pre kicks.factor is
/// not null
void evaluate_noise_factor(const NoiseKicks& kicks, int count, const double* y, const double* v,
                           double* g);

/// Applies a kick of multiplicative noise to each of at most 8 trajectory streams. A kick of
/// multiplicative noise is the exact solution of the equation dv = sqrt(2D) g(y, v) o dW in
/// Stratonovich's sense at a fixed displacement y, over a time h: the flow dv/ds = g(y, v) for the
/// duration s = sqrt(2D h) N(0, 1).
void apply_multiplicative_kicks(const StreamMotionParameters& motion,
                                TrajectoryStream* const* streams, int count);

}  // namespace fpkcheck::mcs
