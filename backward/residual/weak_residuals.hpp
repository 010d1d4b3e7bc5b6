#pragma once

#include <Eigen/Core>
#include <vector>

#include "backward/control_variates/control_variate_fit.hpp"
#include "backward/control_variates/generator_factors.hpp"
#include "backward/residual/density_reconstruction.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::backward {

/// Weak residuals of the stationary density equation for a density p with integral 1, and further
/// integrals of the density. The splines A_i(y) and B_j(v) of a WeakResidualIntegrator are the test
/// functions of the weak residuals.
struct DensityIntegrals {
  double mass;  ///< mass of the density before the normalisation
  transform::Moments moments;
  Eigen::MatrixXd spline_means;    ///< E_p[A_i(y) B_j(v)], shape (functions of y, functions of v)
  Eigen::MatrixXd weak_residuals;  ///< rho_ij, shape (functions of y, functions of v)
  /// Probabilities of the cells between the breaks of the splines, shape (cells of y, cells of v)
  Eigen::MatrixXd cell_probabilities;
  /// Impact fluxes int u p(0, -u) du over the intervals of the impact speed u between consecutive
  /// impact_speed_breaks(), one vector for each wall
  std::vector<Eigen::VectorXd> impact_fluxes;
};

/// Computes weak residuals of a density p in the stationary equation with impulses and the exact
/// impact condition (equation `kf`, impact `map`),
///
///     rho_ij = int p L(A_i B_j) dy dv + A_i(0) int u p(0, -u) [B_j(r u) - B_j(-u)] du,
///
/// with the last term for each wall. At a right wall, y = b, the last spline of y replaces A_0, and
/// the integrand over the impact speed is u p(b, u) [B_j(-r u) - B_j(u)]. The weak residuals of the
/// exact stationary density are 0 for any splines. The sum of all spline products A_i B_j is 1,
/// therefore the sum of all weak residuals rho_ij is
/// 0. Each term of L A_i B_j is a product of a function of y and a function of v, and the density p
/// is integrated first along one axis, then along the other.
class WeakResidualIntegrator {
 public:
  /// @param problem problem in wall coordinates; the moments are in physical coordinates
  /// @param splines splines of y from wall to wall, or over the range of the motion; splines of v
  /// with a break at 0
  WeakResidualIntegrator(const problem::Problem& problem, ControlVariateSplines splines);

  /// Computes the weak residuals and integrals of a density in wall coordinates.
  /// @throws InputError as sample_density(), and when the integral of the density is not positive
  DensityIntegrals integrate_density(const transform::Density& density) const;

  const numerics::QuinticBSplines& y_splines() const { return y_splines_; }
  const numerics::QuinticBSplines& v_splines() const { return v_splines_; }

 private:
  Eigen::MatrixXd interpolate_means_after_impulse(std::span<const double> v) const;
  Eigen::RowVectorXd integrate_impact_terms(const WallWithRestitution& wall,
                                            const SampledWallDensity& wall_density) const;

  problem::Problem problem_;
  numerics::QuinticBSplines y_splines_, v_splines_;
  std::vector<WallWithRestitution> walls_;
  std::vector<ImpactSpeedBreakpoints> impact_breaks_;
  std::vector<double> v_breaks_;  // breaks of the splines B_j and of their means K B_j
  // Eight Gauss points between consecutive breaks of the velocity (v_breaks_), in increasing order
  std::vector<double> gauss_velocities_;
  // Means K B_j of the splines after an impulse at the Gauss points, shape (Gauss points, splines)
  Eigen::MatrixXd means_at_gauss_velocities_;
};

}  // namespace fpkcheck::backward
