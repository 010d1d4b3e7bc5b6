#pragma once

#include <vector>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"
#include "transform/spectrum.hpp"

namespace fpkcheck::fd_fpk {

/// Computes the one-sided spectral density of y or y' from the generator L and the stationary
/// density p,
///
///     G(w) = (2/pi) Re <f, (i w - L)^-1 (f - E f) p>,   f = y or y'.
///
/// The errors follow from three or more grids (ConvergedValues); the status is `inaccurate` if an
/// error exceeds Options::accuracy times the largest density.
/// @param frequencies angular frequencies w >= 0
/// @throws InputError for invalid options
transform::Spectrum solve_spectrum(const problem::Problem& problem, const Options& options,
                                   transform::StateVariable variable,
                                   const std::vector<double>& frequencies);

}  // namespace fpkcheck::fd_fpk
