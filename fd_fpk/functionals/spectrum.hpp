#pragma once

#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/spectrum.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the one-sided spectral density of y or y' from the generator L and the stationary
/// density p,
///
///     G(w) = (2/pi) Re <f, (i w - L)^-1 (f - E f) p>,   R(t) = <f, exp(L t) (f - E f) p>,
///
/// with the autocovariance R and f = y or y'.
///
/// The errors follow from three or more grids (FunctionalValuesFromGridSequence); the status is
/// `inaccurate` if an error exceeds FiniteVolumeOptions::accuracy times the largest density.
/// @param frequencies angular frequencies w >= 0
/// @param lags increasing times t >= 0 of the autocovariance R(t)
/// @throws InputError for invalid options
transform::SpectralDensity solve_spectrum(const problem::Problem& problem,
                                          const FiniteVolumeOptions& options,
                                          transform::StateVariable variable,
                                          const std::vector<double>& frequencies,
                                          const std::vector<double>& lags = {});

}  // namespace fpkcheck::fd_fpk
