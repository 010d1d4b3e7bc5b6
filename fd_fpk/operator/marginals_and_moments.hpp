#pragma once

#include <Eigen/Core>
#include <functional>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "problem/balances.hpp"
#include "problem/effective_potential.hpp"
#include "problem/initial_density.hpp"
#include "problem/motion_scales.hpp"
#include "transform/joint_density.hpp"
#include "transform/marginal_density.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::fd_fpk {

/// Averages of the marginal densities over the cells of each axis.
struct MarginalCellAverages {
  Eigen::VectorXd y;     ///< averages of p(y), shape (nx)
  Eigen::VectorXd ydot;  ///< averages of p(y'), shape (nv)
};
MarginalCellAverages marginals(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages);

/// Returns the moments E[x^n] and E[x'^n] of a density given by cell averages, in the coordinates x
/// of the grid. The quadrature of moments has the order of accuracy of the operator.
transform::Moments moments(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                           int scheme_order);

/// Returns the moments E[y^n] and E[y'^n] of a density in physical coordinates.
transform::Moments physical_moments(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                                    const Eigen::VectorXd& cell_averages, int scheme_order);

/// Estimates the magnitude of the moments that the finite computational box omits. The omitted
/// moments are due to the tails outside the computational box, extrapolated from the marginal
/// densities, and to motion that would return from outside the computational box.
transform::Moments moments_outside_box(const problem::Problem& problem, const PhasePlaneGrid& grid,
                                       const Eigen::VectorXd& cell_averages,
                                       const transform::Moments& moments_in_box);

/// Returns the cell averages of the product x1 p or x2 p, for given cell averages of the density p.
Eigen::VectorXd multiply_by_coordinate(const PhasePlaneGrid& grid,
                                       const Eigen::VectorXd& cell_averages,
                                       transform::StateVariable coordinate, int scheme_order);
/// Returns the vector w such that w . P is the mean E[x1] or E[x2] of a density with the cell
/// averages P and mass 1.
Eigen::VectorXd coordinate_mean_functional(const PhasePlaneGrid& grid,
                                           transform::StateVariable coordinate, int scheme_order);

/// Returns the mixed moment E[y y'] in physical coordinates; 0 for a stationary density.
double physical_mixed_moment(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                             const Eigen::VectorXd& cell_averages, int scheme_order);

/// Returns the mean energy E[v^2]/2 + E[U(y)], with the potential U of the spring. The mean energy
/// is a linear function of the cell averages: if the argument is the rate of change of the cell
/// averages, the result is the rate of change of the mean energy.
double mean_energy(const problem::EffectivePotential& spring_potential, const PhasePlaneGrid& grid,
                   const Eigen::VectorXd& cell_averages, int scheme_order);

/// Returns the speed moment of the density p at a wall, int_{v<0} |v|^n p(0, v) dv, or int_{v>0}
/// v^n p(b, v) dv at a right wall b, where n >= 1 is the argument `speed_exponent`. The speed
/// moment with n = 1 is the impact rate.
double wall_speed_moment(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                         int scheme_order, int speed_exponent, AxisEnd end = AxisEnd::left);

/// Returns the sum of weight(u) over all impacts at a wall per unit time, where u is the impact
/// speed: int_{u>0} u weight(u) p(a, -u) du at the left wall a.
double sum_over_impacts(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                        int scheme_order, const std::function<double(double)>& weight, AxisEnd end);

/// Returns the mean power E[v f] of the damping force f at the velocity v.
/// @param moments moments of the density in the coordinates of the grid
double mean_damping_power(const problem::System& system, const transform::Moments& moments,
                          const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                          int scheme_order);

/// Returns the mean absolute power E[|v f|] of the damping force f at the velocity v.
double mean_absolute_damping_power(const problem::System& system, const PhasePlaneGrid& grid,
                                   const Eigen::VectorXd& cell_averages, int scheme_order);

/// Returns the terms of the power balance of a density given by cell averages.
/// @param moments moments of the density in the coordinates of the grid
problem::PowerBalanceTerms power_balance_terms(const problem::Problem& problem,
                                               problem::ImpactCondition impact,
                                               const transform::Moments& moments,
                                               const PhasePlaneGrid& grid,
                                               const Eigen::VectorXd& cell_averages,
                                               int scheme_order);

double power_balance_residual(const problem::Problem& problem, problem::ImpactCondition impact,
                              const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                              int scheme_order);

/// Momentum that the walls give in impacts and contact per unit time.
struct WallMomentumTransfer {
  /// Momentum that each wall gives in impacts, per unit time (MomentumBalanceTerms). The momentum
  /// that the left wall gives includes the momentum of impulses on mass at rest in contact.
  double left = 0, right = 0;
  /// Contribution of mass at rest in contact to E[y]. On mass at rest in contact the wall force
  /// balances the spring force, so that the momentum balance contains neither force.
  double displacement_at_rest = 0;
};

/// Returns the residuals of problem::virial_balance and problem::momentum_balance. Without a wall
/// and with impulses of mean zero, the two sides of the momentum balance are 0, and the residual of
/// the momentum balance is absent.
/// @param walls momentum that the walls give; ignored for problems without a wall
transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const PhasePlaneGrid& grid,
                                              const Eigen::VectorXd& cell_averages,
                                              int scheme_order, const WallMomentumTransfer& walls);
WallMomentumTransfer wall_momentum_transfer(const problem::System& system,
                                            const PhasePlaneGrid& grid,
                                            const Eigen::VectorXd& cell_averages, int scheme_order);

/// Returns the density on the edges of the computational box, relative to the smaller of the peak
/// of the density and the peak of the density of equivalent linearisation. The peak of equivalent
/// linearisation is used, since in comparison with a spike of the density at a rest point a
/// significant density on the edges would appear negligible.
BoxEdgeDensity relative_box_edge_density(const problem::MotionScales& scales,
                                         const PhasePlaneGrid& grid,
                                         const Eigen::VectorXd& cell_averages);

/// Returns the cell averages of a Gaussian density, truncated to the grid and normalised to mass 1.
Eigen::VectorXd gaussian_cell_averages(const problem::InitialGaussian& gaussian,
                                       const PhasePlaneGrid& grid);

/// Returns the cell averages of the Gaussian density of problem::MotionScales, truncated at the
/// walls and normalised to mass 1. Time steps and iterations start from the truncated Gaussian.
Eigen::VectorXd initial_gaussian(const PhasePlaneGrid& grid, const problem::MotionScales& scales);

}  // namespace fpkcheck::fd_fpk
