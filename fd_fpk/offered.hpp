#pragma once

#include <string>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Why this solver does not treat a problem, in one phrase; empty where it does.
std::string objection(const problem::Problem& problem, const Options& options);

/// Likewise of a density over time, for which there are differences alone.
std::string objection_over_time(const problem::Problem& problem, const Options& options);

/// Characteristics are offered where the motion between impulses is that of the equation, unless the
/// options ask for what they do not have.
bool may_follow_characteristics(const Options& options);

/// Why the density of `kf` cannot be followed along characteristics (fd_fpk/characteristics/), which
/// go from walls and the sides of the box to rest: all motion has to lose energy.
std::string characteristics_objection(const problem::Problem& problem);

/// The mass comes to rest in contact with a wall, and the law of this equation has an atom there.
bool rests_in_contact(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
