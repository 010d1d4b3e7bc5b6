#pragma once

#include "problem/system.hpp"

namespace fpkcheck::path_integration {

/// The state of the motion without excitation a time T before a final state x, and the ratio of the
/// densities: the density p(x) at the final time is growth p(y, v) at the earlier time.
struct EarlierState {
  double y, v;
  double growth;
};

/// Returns the state from which the motion without excitation reaches (y, v) after the time
/// `duration`. The steps of the fourth-order Runge-Kutta method end at impacts. Between impacts the
/// motion contracts areas by the factor exp(-int df/dv dt) with the force f(y, v), and at an impact
/// of the speed u by r(u) d(u r(u))/du; the growth is the reciprocal of the product.
/// @param max_step largest step of the Runge-Kutta method
/// @pre (y, v) is between the walls, duration > 0, max_step > 0, and the force has no jump in v
EarlierState earlier_state(const problem::System& system, double y, double v, double duration,
                           double max_step);

}  // namespace fpkcheck::path_integration
