#pragma once

#include <Eigen/Core>

#include "fd_fpk/operator/grid.hpp"
#include "fd_fpk/operator/operator.hpp"
#include "problem/energy_balance.hpp"
#include "problem/scales.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// The marginals' averages over the cells of each line.
struct Marginals {
  Eigen::VectorXd y;     ///< shape (nx), on the cells of x1
  Eigen::VectorXd ydot;  ///< shape (nv), on the cells of x2
};
Marginals marginals(const Grid& grid, const Eigen::VectorXd& averages);

/// E[x^n], E[x'^n] from cell averages, with the same order as the operator, in the grid's
/// coordinates: y where the problem is its own frame.
transform::Moments moments(const Grid& grid, const Eigen::VectorXd& averages, int order);

/// E[y^n], E[y'^n] of cell averages in coordinates x: of y = frame.y(x), y' = frame.v(x').
transform::Moments physical_moments(const problem::Frame& frame, const Grid& grid,
                                    const Eigen::VectorXd& averages, int order);

/// An estimate of what the moments lack, in size, because the box ends: the tails beyond, as the
/// marginals fall before them, and what would come back from there.
/// @param of_all the moments in the box
transform::Moments beyond_box(const problem::Problem& problem, const Grid& grid,
                              const Eigen::VectorXd& averages, const transform::Moments& of_all);

/// E[y y'] likewise, which is 0 of what is stationary.
double physical_yv(const problem::Frame& frame, const Grid& grid, const Eigen::VectorXd& averages,
                   int order);

/// E[v^2]/2 + E[U(y)], U the potential of the spring: averaged over the cells as the operator
/// averages the force. Linear in the averages, so that the rate of a density gives the energy's.
double mean_energy(const problem::System& system, const Grid& grid, const Eigen::VectorXd& averages,
                   int order);

/// int_{v<0} |v|^power p(0, v) dv, or int_{v>0} v^power p(b, v) dv at the end b, from the
/// extrapolation to the wall that the operator uses; power >= 1: 1 is the impact rate, 3 enters the
/// energy balance.
double impact_flux(const Grid& grid, const Eigen::VectorXd& averages, int order, int power,
                   End end = End::left);

/// E[v f] of cell averages with these moments (in the grid's coordinates).
double mean_damping_power(const problem::System& system, const transform::Moments& moments,
                          const Grid& grid, const Eigen::VectorXd& averages, int order);

/// What the balance of power needs of cell averages with these moments (in the grid's coordinates).
problem::EnergyTerms energy_terms(const problem::System& system, const transform::Moments& moments,
                                  const Grid& grid, const Eigen::VectorXd& averages, int order);

/// problem::energy_residual of cell averages.
double energy_residual(const problem::Problem& problem, problem::Impact impact, const Grid& grid,
                       const Eigen::VectorXd& averages, int order);

/// What reaches the walls per unit time.
struct MomentumAtWalls {
  double left_momentum = 0;   ///< int_{v<0} v^2 p(0, v) dv, and that of impulses at rest
  double right_momentum = 0;  ///< likewise
  /// Of the mass at rest in contact, part of E[y]. The force on it the wall takes, and neither counts.
  double displacement_at_rest = 0;
};

/// problem::virial_balance and problem::momentum_balance of cell averages. The force is averaged
/// over the cells as the operator averages it. Without a wall and without a mean of the impulses
/// there is no residual of momentum: both sides are 0.
/// @param walls not looked at where there is none
transform::BalanceResiduals balance_residuals(const problem::Problem& problem, const Grid& grid,
                                              const Eigen::VectorXd& averages, int order,
                                              const MomentumAtWalls& walls);
/// As the density has it at the walls.
MomentumAtWalls momentum_at_walls(const problem::System& system, const Grid& grid,
                                  const Eigen::VectorXd& averages, int order);

/// Density on the outer walls relative to the peak, or to the peak of equivalent linearisation
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
/// Cell averages of it between the ends of the grid, cut off there, with mass 1.
Eigen::VectorXd averages_of(const Gaussian& gaussian, const Grid& grid);

/// Cell averages, with mass 1, of the Gaussian of (z, z') with mean zero and these deviations,
/// folded to the half-plane: twice its density on y >= 0.
Eigen::VectorXd folded_gaussian(const Grid& grid, double displacement_deviation,
                                double velocity_deviation);

/// Cell averages of the density of equivalent linearisation on the half-plane, mass 1: the start of
/// the march and of the inverse iteration. Beyond the paper's class the Gaussian of problem::Scales
/// between the walls.
Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem);
Eigen::VectorXd gaussian_start(const Grid& grid, const problem::Problem& problem,
                               const problem::Scales& scales);

}  // namespace fpkcheck::fd_fpk
