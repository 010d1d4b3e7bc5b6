#pragma once

#include <string>

#include "problem/problem.hpp"
#include "workflows/sweep/result/groups.hpp"

namespace fpkcheck::sweep {

/// All that the density of a problem depends on, but for units.
struct Place {
  Groups groups;
  double restitution;
  std::string law;
  double mean_share;  ///< E[Y] / sqrt(E[Y^2])
};

Place place_of(const problem::Problem& problem);

/// How different two problems are:
///
///     sqrt( (ln N1/N2)^2 + (ln zeta1/zeta2)^2 + ((r1 - r2)/0.1)^2 + ((s1 - s2)/0.2)^2 ),
///
/// N impulses per decay time, zeta the damping ratio, r the restitution, s the cubic share. One unit
/// is a factor e in N or zeta, 0.1 in r, or a fifth of the stiffness that is cubic instead of linear.
/// docs/validity.md has what that does to errors. Infinite between different laws or different mean
/// shares.
double distance(const Place& one, const Place& other);

}  // namespace fpkcheck::sweep
