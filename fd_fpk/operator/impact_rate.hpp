#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/model.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// Number of impacts per unit time, summed over all walls, for a density given by cell averages.
///
/// At a wall without losses, or for an equation without white noise (without a second derivative of
/// p), the impact rate is the flux of probability into the wall, int_{v<0} |v| p(0, v) dv. The
/// density at the wall is extrapolated by the stencils of the Fokker-Planck operator.
///
/// With white noise and losses p(0, v) ~ |v|^-beta (exact::wall_exponent). Cell averages do not
/// resolve this singularity: the flux converges only with the power 2 - beta of the width of the
/// narrowest cells. The impact rate follows instead from the balance (Dynkin's formula) of the
/// expectation of a test function h, which every impact increases by an equal amount
/// (wall_test_function.hpp),
///
///     (pi / sqrt 3 + log r) rate = E[F h_v - F_0 f_v] - <h, S p> + d/dt E[h]
///                                  - int u p(b, u) [h(b, -r_b u) - h(b, u)] du,
///
/// with F the force and damping less the drift of the excitation, S the excitation without drift
/// and noise (jumps), b a second wall. The integrand F h_v - F_0 f_v is bounded at the wall, so
/// that the error of the impact rate is proportional to the power 4 - beta of the width of the
/// narrowest cells. For the paper's impact to first order in 1-r, r - 1 replaces log r.
///
/// @param excitation the excitation on the x2 axis of the grid, equal to that of the operator whose
/// density has these cell averages
/// @param rate_of_change the rate of change of the averages; 0 for a stationary density
double impact_rate(const problem::System& system, const Excitation& excitation,
                   problem::Impact impact, const Grid& grid, const Eigen::VectorXd& averages,
                   const Eigen::VectorXd& rate_of_change, int scheme_order);

/// The flux of probability into the walls, with the density at the walls extrapolated by the
/// stencils of the Fokker-Planck operator. The density must be bounded at the walls.
double flux_into_walls(const problem::System& system, const Grid& grid,
                       const Eigen::VectorXd& averages, int scheme_order);

}  // namespace fpkcheck::fd_fpk
