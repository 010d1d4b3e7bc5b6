#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {

/// Returns the number of impacts per unit time, summed over all walls, for a density given by cell
/// averages. Without losses at the wall, or without diffusion in the equation, the impact rate is
/// the probability flux into the wall, int_{v<0} |v| p(0, v) dv.
///
/// Under white noise with losses at the wall, the density p(0, v) is proportional to |v|^-beta
/// (exact::wall_exponent). Cell averages do not resolve the singularity |v|^-beta of the density:
/// the probability flux into the wall converges only with the power 2 - beta of the narrowest cell
/// width. Under white noise with losses the impact rate follows from the balance (Dynkin's formula)
/// of a test function h, which every impact increases by an equal amount (wall_test_function.hpp):
///
///     (pi / sqrt 3 + log r) rate = E[F h_v - F_0 f_v] - <h, S p> + d/dt E[h]
///                                  - int u p(b, u) [h(b, -r_b u) - h(b, u)] du,
///
/// In the balance of the test function h, F is the sum of restoring and damping force minus the
/// drift of the excitation, F_0 is the value of F at the wall, S is the operator of the velocity
/// jumps, and x1 = b is a second wall. The integrand F h_v - F_0 f_v is bounded at the wall, so
/// that the error of the impact rate is proportional to the power 4 - beta of the narrowest cell
/// width. For the impact condition to first order in 1-r, the balance of h contains r - 1 in place
/// of log r. Under multiplicative noise, and at walls whose restitution coefficient depends on the
/// impact speed, the impact rate is the probability flux into the wall.
///
/// @param excitation excitation on the velocity axis of the grid, as in the Fokker-Planck operator
/// @param rate_of_change rate of change of the cell averages; 0 for a stationary density
double impact_rate(const problem::System& system, const DiscretisedExcitation& excitation,
                   problem::ImpactCondition impact, const PhasePlaneGrid& grid,
                   const Eigen::VectorXd& cell_averages, const Eigen::VectorXd& rate_of_change,
                   int scheme_order);

/// Returns the flux of probability into the walls, extrapolated from cell averages by the stencils
/// of the Fokker-Planck operator; the density must be bounded at the walls.
double flux_into_walls(const problem::System& system, const PhasePlaneGrid& grid,
                       const Eigen::VectorXd& cell_averages, int scheme_order);

}  // namespace fpkcheck::fd_fpk
