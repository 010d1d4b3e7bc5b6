#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::sweep {

/// The dimensionless groups of a problem. Two problems with the same groups, restitution
/// coefficient and impulse law have the same density up to the units of length and time. The groups
/// determine the density only for problems of the base class (problem/features.hpp); other problems
/// have more groups.
struct DimensionlessGroups {
  double impulses_per_decay_time;  ///< lambda / kappa (problem::impulses_per_decay_time)
  double damping_ratio;            ///< c / (2 sqrt(k_eq)), k_eq of equivalent linearisation
  /// The cubic fraction of the stiffness, 1 - k / k_eq: 0 for a linear spring, 1 for a purely cubic
  /// spring; NaN for problems outside the base class.
  double cubic_share;
};

DimensionlessGroups dimensionless_groups(const problem::Problem& problem);

}  // namespace fpkcheck::sweep
