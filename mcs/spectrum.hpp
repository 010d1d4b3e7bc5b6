#pragma once

#include <vector>

#include "mcs/options.hpp"
#include "problem/problem.hpp"
#include "transform/spectrum.hpp"

namespace fpkcheck::mcs {

/// Estimates the one-sided spectral density of y or y' by Welch's method: periodograms of
/// half-overlapping segments of y with Hann's window, averaged over all segments of a trajectory
/// stream and over the streams with TrajectoryStreamWeights. The spectrum of y' is computed as the
/// squared frequency w^2 times the spectrum of y, since the spectrum of samples of y' decreases
/// only as w^-2 and would have a large alias.
///
/// The errors of the spectrum combine standard errors from the differences between streams with two
/// estimates of the bias: the alias, from the decrease of the spectrum G(w) ~ w^-4 above the
/// largest frequency, and the smoothing by the spectral window, from a second spectrum with
/// segments of half the length. The autocovariance is the Fourier transform of the averaged
/// periodograms, divided by the autocorrelation of Hann's window. Under noise the
/// errors contain an estimate of the error by the interval between noise kicks, from a second
/// simulation with twice the interval.
/// @param frequencies increasing angular frequencies w >= 0
/// @param lags increasing times t >= 0 of the autocovariance R(t)
/// @throws InputError as make_simulation_plan()
transform::SpectralDensity estimate_spectrum(const problem::Problem& problem,
                                             const SimulationOptions& options,
                                             transform::StateVariable variable,
                                             const std::vector<double>& frequencies,
                                             const std::vector<double>& lags = {});

}  // namespace fpkcheck::mcs
