#pragma once

#include <string>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Why this solver does not treat a problem, in one phrase; empty where the solver treats the
/// problem.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

/// As unsupported_reason, for a density over time: only upwind differences compute one.
std::string transient_unsupported_reason(const problem::Problem& problem, const Options& options);

/// The options allow characteristics: equation `kf` with the impact `map`, and no option that
/// characteristics lack (cell numbers, grading, order, transport by differences).
bool can_use_characteristics(const Options& options);

/// Why the density of `kf` cannot be computed along characteristics (fd_fpk/characteristics/);
/// empty where it can. Characteristics start at walls and on the sides of the box and end at rest
/// points, so every motion has to lose energy.
std::string characteristics_unsupported_reason(const problem::Problem& problem);

/// True where mass comes to rest in contact with a wall, so that the law of this equation has an
/// atom there.
bool rests_in_contact(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
