#pragma once

#include <Eigen/Core>

#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "problem/energy_balance.hpp"
#include "problem/scales.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// Averages of the marginal densities over the cells of each axis.
struct Marginals {
  Eigen::VectorXd y;     ///< shape (nx), on the cells of x1
  Eigen::VectorXd ydot;  ///< shape (nv), on the cells of x2
};
Marginals marginals(const Grid& grid, const Eigen::VectorXd& averages);

/// E[x^n], E[x'^n] from cell averages, with the order of the operator, in the grid's coordinates
/// (equal to y where the wall coordinates are the physical ones).
transform::Moments moments(const Grid& grid, const Eigen::VectorXd& averages, int order);

/// E[y^n], E[y'^n] of cell averages in coordinates x: of y = frame.y(x), y' = frame.v(x').
transform::Moments physical_moments(const problem::Frame& frame, const Grid& grid,
                                    const Eigen::VectorXd& averages, int order);

/// Estimated magnitude of the moments missing because the box is finite: the tails outside,
/// extrapolated from the marginals, and the motion that would return from there.
/// @param moments_in_box the moments in the box
transform::Moments moments_outside_box(const problem::Problem& problem, const Grid& grid,
                                       const Eigen::VectorXd& averages,
                                       const transform::Moments& moments_in_box);

/// E[y y'] likewise; 0 for a stationary density.
double physical_yv(const problem::Frame& frame, const Grid& grid, const Eigen::VectorXd& averages,
                   int order);

/// E[v^2]/2 + E[U(y)], with the potential U of the spring averaged over cells as the operator
/// averages the force. Linear in the averages: applied to the rate of change of a density, the
/// result is the rate of change of energy.
double mean_energy(const problem::System& system, const Grid& grid, const Eigen::VectorXd& averages,
                   int order);

/// int_{v<0} |v|^power p(0, v) dv, or int_{v>0} v^power p(b, v) dv at the end b, from the
/// extrapolation to the wall in the operator; power >= 1. Power 1 is the impact rate; power 3
/// enters the energy balance.
double impact_flux(const Grid& grid, const Eigen::VectorXd& averages, int order, int power,
                   End end = End::left);

/// E[v f], the mean damping power, of cell averages with these moments (in the grid's coordinates).
double mean_damping_power(const problem::System& system, const transform::Moments& moments,
                          const Grid& grid, const Eigen::VectorXd& averages, int order);

/// The terms of the power balance for cell averages with these moments (in the grid's coordinates).
problem::EnergyTerms energy_terms(const problem::System& system, const transform::Moments& moments,
                                  const Grid& grid, const Eigen::VectorXd& averages, int order);

/// problem::energy_residual of cell averages.
double energy_residual(const problem::Problem& problem, problem::Impact impact, const Grid& grid,
                       const Eigen::VectorXd& averages, int order);

/// Momentum transferred to the walls per unit time.
struct MomentumAtWalls {
  double left_momentum = 0;   ///< int_{v<0} v^2 p(0, v) dv, plus that of impulses on mass at rest
  double right_momentum = 0;  ///< likewise at the right wall
  /// Contribution of mass at rest in contact to E[y]. The wall balances the force on this mass, so
  /// neither enters the momentum balance.
  double displacement_at_rest = 0;
};

/// problem::virial_balance and problem::momentum_balance of cell averages. The force is averaged
/// over cells as in the operator. Without a wall and without a mean of the impulses there is no
/// momentum residual: both sides are 0.
/// @param walls ignored where there is no wall
transform::BalanceResiduals balance_residuals(const problem::Problem& problem, const Grid& grid,
                                              const Eigen::VectorXd& averages, int order,
                                              const MomentumAtWalls& walls);
/// The momentum transfer of a density at the walls.
MomentumAtWalls momentum_at_walls(const problem::System& system, const Grid& grid,
                                  const Eigen::VectorXd& averages, int order);

/// Density on the walls of the box relative to the peak, or to the peak of equivalent linearisation
/// where that is lower: a spike at rest must not hide a tail.
WallDensity relative_wall_density(const problem::Problem& problem, const Grid& grid,
                                  const Eigen::VectorXd& averages);
WallDensity relative_wall_density(const problem::Scales& scales, const Grid& grid,
                                  const Eigen::VectorXd& averages);

/// Independent Gaussians of x and x'.
struct Gaussian {
  double displacement_deviation, velocity_deviation;
  double mean_displacement = 0, mean_velocity = 0;
};
/// Cell averages of the Gaussian truncated at the ends of the grid, with mass 1.
Eigen::VectorXd cell_averages(const Gaussian& gaussian, const Grid& grid);

/// Cell averages, with mass 1, of the Gaussian of (z, z') with mean zero and these standard
/// deviations, folded to the half-plane: twice its density on y >= 0.
Eigen::VectorXd folded_gaussian(const Grid& grid, double displacement_deviation,
                                double velocity_deviation);

/// Cell averages, with mass 1, of the density of equivalent linearisation on the half-plane: the
/// initial density of time steps and of iterations. Outside the paper's class the Gaussian of
/// problem::Scales between the walls.
Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem);
Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem,
                               const problem::Scales& scales);

}  // namespace fpkcheck::fd_fpk
