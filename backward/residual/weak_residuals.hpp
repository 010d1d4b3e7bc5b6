#pragma once

#include <Eigen/Core>
#include <vector>

#include "backward/control/generator_factors.hpp"
#include "backward/residual/sampled_density.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::backward {

/// What a density of mass 1 does to the stationary equation when this is tested by splines, and
/// what else integrals of the density tell.
struct WeakForm {
  double mass;  ///< before it was divided by
  transform::Moments moments;
  Eigen::MatrixXd means;      ///< E_p[A_i(y) B_j(v)]
  Eigen::MatrixXd residuals;  ///< rho_ij; both of shape (functions of y, functions of v)
  /// Probabilities of the cells between the breaks of the splines, shape (cells of y, of v).
  Eigen::MatrixXd cells;
  /// int u p(0, -u) du between breaks_of_jumps(), for each of impact_walls().
  std::vector<Eigen::VectorXd> impacts;
};

/// The weak residuals of the stationary equation with the exact impact under the impulses
/// themselves (equation `kf`, impact `map`),
///
///     rho_ij = int p L(A_i B_j) dy dv + A_i(0) int u p(0, -u) [B_j(r u) - B_j(-u)] du,
///
/// the last for each wall (at a right one, x = b, the last function of y takes the place of A_0, and
/// p(b, u) [B_j(-r u) - B_j(u)] that of the integrand), which vanish for its solution, whatever the
/// splines. As all A_i B_j sum to 1, all rho_ij sum to
/// 0. Each term of L A_i B_j is a product, so p is integrated along one axis and then
/// along the other.
class WeakResiduals {
 public:
  /// @param problem in its frame; moments are those of the physical coordinates
  /// @param y splines from wall to wall, or as far as there is motion; v with 0 among the breaks
  WeakResiduals(const problem::Problem& problem, numerics::KnotSplines y, numerics::KnotSplines v);

  /// @throws InputError as sampled() does, and when the mass is not positive
  WeakForm operator()(const transform::Density& density) const;

  const numerics::KnotSplines& y() const { return y_; }
  const numerics::KnotSplines& v() const { return v_; }

 private:
  Eigen::MatrixXd means_after_impulse(std::span<const double> v) const;
  Eigen::RowVectorXd impacts(const ImpactWall& wall, const SampledImpacts& impacts) const;

  problem::Problem problem_;
  numerics::KnotSplines y_, v_;
  std::vector<ImpactWall> walls_;
  std::vector<ImpactBreaks> wall_breaks_;
  std::vector<double> v_breaks_;  // of B_j and K B_j
  /// K B_j at eight points of Gauss's rule between neighbouring breaks of v, increasing.
  std::vector<double> nodes_;
  Eigen::MatrixXd means_;  // shape (nodes, functions)
};

}  // namespace fpkcheck::backward
