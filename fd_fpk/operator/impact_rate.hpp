#pragma once

#include <Eigen/Core>

#include "fd_fpk/line/excitation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "problem/model.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// Impacts per unit time of cell averages, the sum over what walls there are.
///
/// A wall without losses, or without noise (a second derivative of p): the flux into it,
/// int_{v<0} |v| p(0, v) dv, from the extrapolation to the wall that the operator uses.
///
/// With noise and losses p(0, v) ~ |v|^-beta (exact::wall_exponent), which no cell holds: the flux out
/// of cells converges with the power 2 - beta of the narrowest ones alone. The rate follows instead
/// from the balance (Dynkin) of a function h that every impact raises by the same
/// (wall_test_function.hpp),
///
///     (pi / sqrt 3 + log r) rate = E[F h_v - F_0 f_v] - <h, S p> + d/dt E[h]
///                                  - int u p(b, u) [h(b, -r_b u) - h(b, u)] du,
///
/// F the force and damping less the drift of the excitation, S what the excitation has beside drift
/// and noise (jumps), b a second wall. The mean is of what is bounded at the wall, so that the
/// narrowest cells enter by the power 4 - beta. The paper's first-order impact has r - 1 for log r.
///
/// @param excitation on the grid's x2; it is what the averages were solved with
/// @param change the rate of change of the averages; 0 of a stationary density
double impact_rate(const problem::System& system, const Excitation& excitation,
                   problem::Impact impact, const Grid& grid, const Eigen::VectorXd& averages,
                   const Eigen::VectorXd& change, int order);

/// The flux into the walls by that extrapolation, whatever the noise: of a density that is bounded there.
double flux_into_walls(const problem::System& system, const Grid& grid,
                       const Eigen::VectorXd& averages, int order);

}  // namespace fpkcheck::fd_fpk
