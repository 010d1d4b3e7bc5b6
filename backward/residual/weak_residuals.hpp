#pragma once

#include <Eigen/Core>
#include <vector>

#include "backward/control/control_function_fit.hpp"
#include "backward/control/generator_factors.hpp"
#include "backward/residual/sampled_density.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::backward {

/// Weak residuals of the stationary equation for a density normalised to mass 1, and further
/// integrals of the density.
struct DensityIntegrals {
  double mass;  ///< mass of the density before the normalisation
  transform::Moments moments;
  Eigen::MatrixXd means;  ///< means E_p[A_i(y) B_j(v)]
  /// Weak residuals rho_ij; `means` and `residuals` have the shape (functions of y, functions of v)
  Eigen::MatrixXd residuals;
  /// Probabilities of the cells between the breaks of the splines, shape (cells of y, cells of v)
  Eigen::MatrixXd cells;
  /// Impact fluxes int u p(0, -u) du over the intervals of the speed u that end at the
  /// non_smooth_impact_speeds(), for each of impact_walls()
  std::vector<Eigen::VectorXd> impacts;
};

/// Weak residuals of the stationary equation with impulses and the exact impact (equation `kf`,
/// impact `map`),
///
///     rho_ij = int p L(A_i B_j) dy dv + A_i(0) int u p(0, -u) [B_j(r u) - B_j(-u)] du,
///
/// with the last term for each wall. At a right wall, x = b, the last function of y replaces A_0
/// and u p(b, u) [B_j(-r u) - B_j(u)] is the integrand. The weak residuals of the exact solution
/// are 0 for any splines. The sum of all A_i B_j is 1, therefore the sum of all rho_ij is 0. Each
/// term of L A_i B_j is a product of a function of y and a function of v, so that p is integrated
/// first along one axis, then along the second axis.
class WeakResiduals {
 public:
  /// @param problem in wall coordinates; the moments are in physical coordinates
  /// @param splines splines of y from wall to wall, or over the range of the motion; splines of v
  /// with 0 among the breaks
  WeakResiduals(const problem::Problem& problem, ControlSplines splines);

  /// @throws InputError as sample_density(), and when the mass is not positive
  DensityIntegrals operator()(const transform::Density& density) const;

  const numerics::QuinticBSplines& y() const { return y_; }
  const numerics::QuinticBSplines& v() const { return v_; }

 private:
  Eigen::MatrixXd interpolated_spline_means_after_impulse(std::span<const double> v) const;
  Eigen::RowVectorXd impact_terms(const ImpactWall& wall, const SampledWallDensity& impacts) const;

  problem::Problem problem_;
  numerics::QuinticBSplines y_, v_;
  std::vector<ImpactWall> walls_;
  std::vector<ImpactBreaks> wall_breaks_;
  std::vector<double> v_breaks_;  // breaks of the splines B_j and of their means K B_j
  /// Eight Gauss points between consecutive breaks of v, in order of increasing v
  std::vector<double> nodes_;
  Eigen::MatrixXd means_;  // shape (nodes, functions)
};

}  // namespace fpkcheck::backward
