#pragma once

#include <string>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Returns, in one phrase, the reason why finite volumes do not solve a problem. The reason is
/// empty if they solve the problem.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

/// Returns the reason why finite volumes do not compute the density of a problem over time; empty
/// if they compute it. Only upwind differences compute a density over time.
std::string transient_unsupported_reason(const problem::Problem& problem, const Options& options);

/// Whether the options allow the transport along characteristics: the equation is `kf` with the
/// impact `map`, and no option is set that only upwind differences have (numbers of cells, grading,
/// order, transport `upwind`).
bool can_use_characteristics(const Options& options);

/// The reason why the density of `kf` cannot be computed along characteristics
/// (fd_fpk/characteristics/). The reason is empty if characteristics can be used. Characteristics
/// start at walls and on the sides of the box and end at rest points, so every motion has to lose
/// energy.
std::string characteristics_unsupported_reason(const problem::Problem& problem);

/// Whether probability mass comes to rest in contact with a wall, so that the stationary law of the
/// equation has an atom at the wall.
bool has_rest_in_contact(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
