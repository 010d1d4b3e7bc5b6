#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/operator/grid.hpp"
#include "problem/model.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// Impacts per unit time of a density given by cell averages; the sum over all walls.
///
/// A wall without losses, or without noise (a second derivative of p): the flux into the wall,
/// int_{v<0} |v| p(0, v) dv, from the extrapolation to the wall in the operator.
///
/// With noise and losses p(0, v) ~ |v|^-beta (exact::wall_exponent), which no cell average
/// represents: the flux converges with the power 2 - beta of the narrowest cells alone. The rate
/// follows instead from the balance (Dynkin) of a function h that every impact raises by the same
/// amount (wall_test_function.hpp),
///
///     (pi / sqrt 3 + log r) rate = E[F h_v - F_0 f_v] - <h, S p> + d/dt E[h]
///                                  - int u p(b, u) [h(b, -r_b u) - h(b, u)] du,
///
/// with F the force and damping less the drift of the excitation, S the excitation without drift
/// and noise (jumps), b a second wall. The expectation is over a function bounded at the wall, so
/// that the narrowest cells enter with the power 4 - beta. For the paper's first-order impact r - 1
/// replaces log r.
///
/// @param excitation on the grid's x2; the excitation of the operator that determined the averages
/// @param change the rate of change of the averages; 0 for a stationary density
double impact_rate(const problem::System& system, const Excitation& excitation,
                   problem::Impact impact, const Grid& grid, const Eigen::VectorXd& averages,
                   const Eigen::VectorXd& change, int order);

/// The flux into the walls by the same extrapolation, with or without noise: for densities bounded
/// at the walls.
double flux_into_walls(const problem::System& system, const Grid& grid,
                       const Eigen::VectorXd& averages, int order);

}  // namespace fpkcheck::fd_fpk
