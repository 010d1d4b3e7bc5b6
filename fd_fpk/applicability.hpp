#pragma once

#include <optional>
#include <string>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the reason why finite volumes cannot solve the problem; empty for a supported problem.
std::string unsupported_reason(const problem::Problem& problem, const FiniteVolumeOptions& options);

/// Returns the options of an equation that is identical to the equation of the given options for
/// the problem. Without impulses all density equations are the Fokker-Planck equation, and at
/// elastic walls the impact condition `delta` is exact. Options of identical equations become equal
/// options, so that one solution serves for all of them. Empty if finite volumes cannot solve the
/// problem.
std::optional<FiniteVolumeOptions> options_of_identical_equation(
    const problem::Problem& problem, const FiniteVolumeOptions& options);

/// Returns why finite volumes cannot compute the density over time; empty for supported problems.
std::string transient_unsupported_reason(const problem::Problem& problem,
                                         const FiniteVolumeOptions& options);

/// Returns whether the options allow transport along characteristics. Transport along
/// characteristics requires the Kolmogorov-Feller equation `kf` with the exact impact condition
/// `map`. Options of upwind differences (number of cells, grading, order) must be unset.
bool can_use_characteristics(const FiniteVolumeOptions& options);

/// Returns the reason why characteristics (fd_fpk/characteristics/) cannot compute the density of
/// the Kolmogorov-Feller equation `kf`; empty if characteristics are applicable. With a wall every
/// motion must lose energy, since characteristics end at rest points; without a wall the motion
/// must tend to a limit cycle.
std::string characteristics_unsupported_reason(const problem::Problem& problem);

/// Returns whether mass comes to rest in contact, as an atom of the stationary law at a wall.
bool has_rest_in_contact(const problem::Problem& problem, const FiniteVolumeOptions& options);

}  // namespace fpkcheck::fd_fpk
