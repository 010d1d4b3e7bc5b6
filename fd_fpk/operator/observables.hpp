#pragma once

#include <Eigen/Core>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "problem/balances.hpp"
#include "problem/scales.hpp"
#include "transform/density.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::fd_fpk {

/// Averages of the marginal densities over the cells of each axis.
struct Marginals {
  Eigen::VectorXd y;     ///< shape (nx), on the cells of x1
  Eigen::VectorXd ydot;  ///< shape (nv), on the cells of x2
};
Marginals marginals(const Grid& grid, const Eigen::VectorXd& averages);

/// The moments E[x^n] and E[x'^n] of a density given by cell averages, in the coordinates of the
/// grid. The quadrature has the order of accuracy of the Fokker-Planck operator. If the wall
/// coordinates are the physical coordinates, x is y.
transform::Moments moments(const Grid& grid, const Eigen::VectorXd& averages, int scheme_order);

/// The moments E[y^n] and E[y'^n] in physical coordinates, y = frame.physical_y(x) and y' =
/// frame.physical_velocity(x'), of a density given by cell averages in the coordinates x of the
/// grid.
transform::Moments physical_moments(const problem::Frame& frame, const Grid& grid,
                                    const Eigen::VectorXd& averages, int scheme_order);

/// Estimates the magnitude of the moments that the finite box omits: the moments of the tails
/// outside the box, extrapolated from the marginal densities, and the moments of the motion that
/// would return from outside the box.
/// @param moments_in_box the moments of the density inside the box
transform::Moments moments_outside_box(const problem::Problem& problem, const Grid& grid,
                                       const Eigen::VectorXd& averages,
                                       const transform::Moments& moments_in_box);

/// The mixed moment E[y y'] in physical coordinates, of a density given by cell averages; 0 for a
/// stationary density.
double physical_mixed_moment(const problem::Frame& frame, const Grid& grid,
                             const Eigen::VectorXd& averages, int scheme_order);

/// The mean energy E[v^2]/2 + E[U(y)]. The potential U of the spring is averaged over cells by the
/// rule by which the Fokker-Planck operator averages the force. The mean energy is linear in the
/// cell averages: applied to the rate of change of the cell averages, mean_energy() gives the rate
/// of change of the energy.
double mean_energy(const problem::System& system, const Grid& grid, const Eigen::VectorXd& averages,
                   int scheme_order);

/// Speed moment of the density at a wall: int_{v<0} |v|^n p(0, v) dv, or int_{v>0} v^n p(b, v) dv
/// at the end b, where n >= 1 is the argument `speed_exponent`. The density at the wall is
/// extrapolated by the stencils of the Fokker-Planck operator. The speed moment with n = 1 is the
/// impact rate; the speed moment with n = 3 occurs in the energy balance.
double impact_flux(const Grid& grid, const Eigen::VectorXd& averages, int scheme_order,
                   int speed_exponent, AxisEnd end = AxisEnd::left);

/// The mean power E[v f] of the damping force f, for a density given by cell averages. The argument
/// `moments` contains the moments of that density, in the coordinates of the grid.
double mean_damping_power(const problem::System& system, const transform::Moments& moments,
                          const Grid& grid, const Eigen::VectorXd& averages, int scheme_order);

/// The terms of the power balance of a density given by cell averages. The argument `moments`
/// contains the moments of that density, in the coordinates of the grid.
problem::EnergyTerms energy_terms(const problem::System& system, const transform::Moments& moments,
                                  const Grid& grid, const Eigen::VectorXd& averages,
                                  int scheme_order);

/// The residual of the power balance, problem::energy_residual, of a density given by cell
/// averages.
double energy_residual(const problem::Problem& problem, problem::Impact impact, const Grid& grid,
                       const Eigen::VectorXd& averages, int scheme_order);

/// Momentum that impacts and contact transfer to the walls per unit time.
struct WallMomentumTransfer {
  /// int_{v<0} v^2 p(0, v) dv, plus the momentum of impulses on mass at rest in contact
  double left_momentum = 0;
  double right_momentum = 0;  ///< momentum transferred to the right wall
  /// Contribution of mass at rest in contact to E[y]. The wall force balances the spring force on
  /// mass at rest in contact, so the momentum balance contains neither of the two forces.
  double displacement_at_rest = 0;
};

/// Residuals of problem::virial_balance and problem::momentum_balance for a density given by cell
/// averages. The force is averaged over cells as in the Fokker-Planck operator. Without a wall, and
/// with impulses of mean zero, there is no momentum residual, because the two sides of the momentum
/// balance are 0.
/// @param walls momentum transferred to the walls; ignored for problems without a wall
transform::BalanceResiduals balance_residuals(const problem::Problem& problem, const Grid& grid,
                                              const Eigen::VectorXd& averages, int scheme_order,
                                              const WallMomentumTransfer& walls);
/// The momentum that a density given by cell averages transfers to the walls per unit time.
WallMomentumTransfer wall_momentum_transfer(const problem::System& system, const Grid& grid,
                                            const Eigen::VectorXd& averages, int scheme_order);

/// Density on the walls of the box, relative to the smaller of two peaks: the peak of the density,
/// and the peak of the density of equivalent linearisation. The peak of equivalent linearisation is
/// needed because a spike of the density at the rest point would make a significant density on the
/// walls appear negligible.
WallDensity relative_wall_density(const problem::MotionScales& scales, const Grid& grid,
                                  const Eigen::VectorXd& averages);

/// A Gaussian density of independent x and x'.
struct Gaussian {
  double displacement_deviation, velocity_deviation;
  double mean_displacement = 0, mean_velocity = 0;
};
/// Cell averages of the Gaussian, truncated at the ends of the grid and normalised to mass 1.
Eigen::VectorXd cell_averages(const Gaussian& gaussian, const Grid& grid);

/// Cell averages, normalised to mass 1, of the Gaussian of problem::MotionScales, truncated at the
/// walls. The truncated Gaussian is the initial density of time steps and of iterations.
Eigen::VectorXd initial_gaussian(const Grid& grid, const problem::MotionScales& scales);

}  // namespace fpkcheck::fd_fpk
