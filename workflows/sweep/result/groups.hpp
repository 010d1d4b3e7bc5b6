#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::sweep {

/// What a problem depends on once units of length and time are taken out: two problems with the same
/// groups, restitution and law of the impulses have the same density but for units; of the paper's
/// class (problem/features.hpp), that is: others have more groups.
struct Groups {
  double impulses_per_decay_time;  ///< lambda / kappa (problem::impulses_per_decay_time)
  double damping_ratio;            ///< c / (2 sqrt(k_eq)), k_eq of equivalent linearisation
  /// 1 - k / k_eq: 0 of a linear spring, 1 of a purely cubic one; NaN beyond the paper's class.
  double cubic_share;
};

Groups groups_of(const problem::Problem& problem);

}  // namespace fpkcheck::sweep
